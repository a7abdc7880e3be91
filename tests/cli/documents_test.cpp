#include "cli/documents.h"

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

using namespace mdbd;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// A program with one of everything.
class Program {
 public:
  Program() : app("Finds it's things.", "mdbd-find") {
    app.footer(
        "Examples:\n  mdbd-find -x a    .dots\n'quotes'\n\nA note.\nExit codes: 0 done, 1 failed.");
    app.add_option("THING", thing, "What to find")->required();
    app.add_option("-o,--output", thing, "Where to [write]: it's\\there")
        ->type_name("FILE")
        ->envname("FIND_OUT");
    app.add_option("--mode", thing, "How")
        ->check(CLI::IsMember({"fast", "slow"}))
        ->type_name("MODE")
        ->default_str("fast");
    app.add_option("--hidden", thing, "Unseen")->group("");
    app.add_flag("--all", flag, "Everything");
    app.add_subcommand("verify", "Check it")->add_flag("--deep", flag, "Look closer");
  }

  CLI::App app;

 private:
  std::string thing;
  bool flag = false;
};

}  // namespace

TEST_CASE("a manual page has what the help says") {
  Program program;
  const std::string page = format_man_page(program.app, "1.2");
  CHECK_THAT(page, StartsWith(".TH MDBD\\-FIND 1 \"\" \"mdbd 1.2\" \"User Commands\"\n.SH NAME\n"
                              "mdbd\\-find \\- finds it's things\n"));
  CHECK_THAT(page, Contains("[\\fIOPTIONS\\fR] \\fICOMMAND\\fR \\fITHING\\fR\n"));
  CHECK_THAT(page, Contains("\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIFILE\\fR\n") &&
                       Contains("it's\\ethere.") && Contains("\\fBFIND_OUT\\fR has it"));
  CHECK_THAT(page,
             Contains("\\fB\\-\\-mode\\fR \\fIMODE\\fR\nHow. One of fast, slow. Default: fast.\n"));
  CHECK_THAT(page, Contains(".TP\n\\fB\\-\\-all\\fR\nEverything.\n") && !Contains("hidden"));
  CHECK_THAT(page, Contains(".SS \\fBmdbd\\-find verify\\fR [\\fIOPTIONS\\fR]\nCheck it.\n") &&
                       Contains("\\-\\-deep"));
  CHECK_THAT(page,
             Contains(".SH EXAMPLES\n.nf\n  mdbd\\-find \\-x a    .dots\n\\&'quotes'\n.fi\n") &&
                 Contains(".SH NOTES\nA note.\n") &&
                 Contains(".SH EXIT STATUS\n0 done, 1 failed.\n"));
}

TEST_CASE("completions have options, choices and commands") {
  Program program;
  const std::string bash = format_completion(program.app, "bash");
  CHECK_THAT(bash, Contains("words=\"-h --help -o --output --mode --all\"") &&
                       Contains("verify) words+=\" -h --help --deep\";") &&
                       Contains("-o|--output) return ;;") && Contains("compgen -W \"fast slow\"") &&
                       Contains("complete -o default -F _mdbd_find mdbd-find\n"));
  const std::string zsh = format_completion(program.app, "zsh");
  CHECK_THAT(zsh,
             StartsWith("#compdef mdbd-find\n") &&
                 Contains("'--output[Where to \\[write\\]\\: it'\\''s\\\\there]:value:_files'") &&
                 Contains("'--mode[How]:value:(fast slow)'") && Contains("verify) _arguments"));
  const std::string fish = format_completion(program.app, "fish");
  CHECK_THAT(fish,
             Contains("complete -c mdbd-find -s o -l output -r -d ") &&
                 Contains("-l mode -x -a 'fast slow' -d 'How'\n") &&
                 Contains("-n __fish_use_subcommand -f -a verify -d 'Check it'\n") &&
                 Contains("-n '__fish_seen_subcommand_from verify' -l deep -d 'Look closer'\n"));
  CHECK(format_completion(program.app, "csh").empty());
}
