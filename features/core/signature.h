#pragma once

#include <string_view>

/// The names of signatures: vectors that describe a shape, computed from its balls.
namespace mdbd {

/// The signature of the paper's section 5: 50 radii and 50 random-walk sums.
inline constexpr std::string_view signature_mdbd_100 = "mdbd-100";

/// The signature that knows where the balls are: features/descriptor/fused_signature.h.
inline constexpr std::string_view signature_mdbd_fused = "mdbd-fused";

/// The name under which the store keeps mdbd-fused. Its number is raised whenever the same balls
/// give another signature: what is stored under an older one is computed again from the balls.
inline constexpr std::string_view stored_mdbd_fused = "mdbd-fused/2";

/// The signatures that can be searched with.
enum class SignatureKind { mdbd_100, mdbd_fused };

constexpr std::string_view to_string(SignatureKind kind) {
  return kind == SignatureKind::mdbd_100 ? signature_mdbd_100 : signature_mdbd_fused;
}

/// The name under which the store keeps the vectors of a signature.
constexpr std::string_view stored_name(SignatureKind kind) {
  return kind == SignatureKind::mdbd_100 ? signature_mdbd_100 : stored_mdbd_fused;
}

}  // namespace mdbd
