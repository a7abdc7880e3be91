#include "evaluation/classifier/classifier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <dlib/dnn.h>

#include "features/core/errors.h"
#include "features/core/random.h"

namespace mdbd {
namespace {

using Row = std::vector<double>;
using Input = dlib::matrix<float, 0, 1>;
// The sizes of the two layers are set when a network is made.
using Net = dlib::loss_multiclass_log<
    dlib::fc<1, dlib::sig<dlib::fc<1, dlib::input<dlib::matrix<float, 0, 1>>>>>>;
constexpr int output_layer = 1;
constexpr int hidden_layer = 3;

// What dlib is given of a set of rows.
struct Samples {
  std::vector<Input> inputs;
  std::vector<unsigned long> labels;
};

// Shifts and scales every column to mean 0 and deviation 1 over the training rows; columns that are
// constant there become 0.
class Standardiser {
 public:
  explicit Standardiser(std::span<const Row> rows) {
    const auto count = static_cast<double>(rows.size());
    for (std::size_t column = 0; column < rows.front().size(); ++column) {
      double sum = 0.0;
      double largest = 0.0;
      for (const Row& row : rows) {
        sum += row[column];
        largest = std::max(largest, std::abs(row[column]));
      }
      const double mean = sum / count;
      double squares = 0.0;
      for (const Row& row : rows) squares += (row[column] - mean) * (row[column] - mean);
      const double deviation = std::sqrt(squares / count);
      const bool is_constant =
          deviation <= count * std::numeric_limits<double>::epsilon() * largest;
      means_.push_back(mean);
      factors_.push_back(is_constant ? 0.0 : 1.0 / deviation);
    }
  }

  std::size_t columns() const { return means_.size(); }

  Input operator()(const Row& row) const {
    if (row.size() != columns()) throw InvalidInput("rows of features differ in length");
    Input input(static_cast<long>(row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!std::isfinite(row[i])) throw InvalidInput("a feature is not finite");
      input(static_cast<long>(i)) = static_cast<float>((row[i] - means_[i]) * factors_[i]);
    }
    return input;
  }

  Samples operator()(const LabelledRows& data, std::size_t class_count) const {
    if (data.rows.size() != data.labels.size())
      throw InvalidInput("rows and labels differ in number");
    Samples samples;
    for (const Row& row : data.rows) samples.inputs.push_back((*this)(row));
    for (const std::size_t label : data.labels) {
      if (label >= class_count) throw InvalidInput("a label is not below the number of classes");
      samples.labels.push_back(label);
    }
    return samples;
  }

 private:
  Row means_;
  Row factors_;
};

// Glorot and Bengio's uniform weights and biases of 0. dlib's own come from std::rand().
template <typename Layer>
void initialise(Layer& layer, Random& random) {
  auto weights = layer.get_weights();
  const double inputs = static_cast<double>(weights.num_samples());
  const double outputs = static_cast<double>(layer.get_num_outputs());
  const double limit = std::sqrt(6.0 / (inputs + outputs));
  float* const values = weights.host();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    values[i] = static_cast<float>(random.uniform(-limit, limit));
  }
}

Net make_network(const Samples& training, std::size_t class_count, int hidden_neurons,
                 Random& random) {
  Net net;
  auto& output = dlib::layer<output_layer>(net).layer_details();
  auto& hidden = dlib::layer<hidden_layer>(net).layer_details();
  output.set_num_outputs(static_cast<long>(class_count));
  hidden.set_num_outputs(hidden_neurons);
  net(training.inputs.front());  // the first use gives the layers their sizes
  initialise(hidden, random);
  initialise(output, random);
  return net;
}

void shuffle(std::vector<std::size_t>& order, Random& random) {
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.index(i)]);
}

// One pass over the training samples in random order.
void run_epoch(Net& net, std::vector<dlib::adam>& solvers, const Samples& training,
               const ClassifierOptions& options, std::vector<std::size_t>& order, Random& random) {
  shuffle(order, random);
  for (std::size_t first = 0; first < order.size(); first += options.batch_size) {
    Samples batch;
    const std::size_t end = std::min(order.size(), first + options.batch_size);
    for (std::size_t i = first; i < end; ++i) {
      batch.inputs.push_back(training.inputs[order[i]]);
      batch.labels.push_back(training.labels[order[i]]);
    }
    net.compute_parameter_gradients(batch.inputs.begin(), batch.inputs.end(), batch.labels.begin());
    net.update_parameters(solvers, options.learning_rate);
  }
}

void validate(const LabelledRows& training, std::size_t class_count,
              const ClassifierOptions& options) {
  if (training.rows.empty()) throw InvalidInput("there are no rows to train on");
  if (training.rows.front().empty()) throw InvalidInput("rows of features are empty");
  const bool is_valid = class_count > 0 && options.hidden_neurons > 0 &&
                        options.learning_rate > 0 && options.weight_decay >= 0 &&
                        options.batch_size > 0 && options.maximum_epochs > 0 &&
                        options.patience > 0;
  if (!is_valid) throw InvalidInput("an option of the classifier is out of range");
  for (const Row& row : training.rows) {
    if (row.size() != training.rows.front().size()) {
      throw InvalidInput("rows of features differ in length");
    }
  }
}

}  // namespace

struct Classifier::Network {
  Standardiser standardise;
  Net net;
};

Classifier::Classifier(std::unique_ptr<Network> network, int epochs)
    : network_(std::move(network)), epochs_(epochs) {}
Classifier::~Classifier() = default;
Classifier::Classifier(Classifier&&) noexcept = default;
Classifier& Classifier::operator=(Classifier&&) noexcept = default;

Classifier train_classifier(const LabelledRows& training, const LabelledRows& validation,
                            std::size_t class_count, const ClassifierOptions& options,
                            std::uint64_t seed) {
  validate(training, class_count, options);
  const Standardiser standardise(training.rows);
  const Samples training_samples = standardise(training, class_count);
  const Samples validation_samples = standardise(validation, class_count);

  Random random(seed);
  Net net = make_network(training_samples, class_count, options.hidden_neurons, random);
  std::vector<dlib::adam> solvers(
      Net::num_computational_layers,
      dlib::adam(static_cast<float>(options.weight_decay), 0.9F, 0.999F));
  std::vector<std::size_t> order(training.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});

  auto best = std::make_unique<Classifier::Network>(Classifier::Network{standardise, net});
  double lowest_loss = std::numeric_limits<double>::infinity();
  int best_epoch = 0;
  const Samples& judges = validation.rows.empty() ? training_samples : validation_samples;
  for (int epoch = 1; epoch <= options.maximum_epochs; ++epoch) {
    if (epoch - best_epoch > options.patience) break;
    run_epoch(net, solvers, training_samples, options, order, random);
    const double loss =
        net.compute_loss(judges.inputs.begin(), judges.inputs.end(), judges.labels.begin());
    if (!(loss < lowest_loss)) continue;
    lowest_loss = loss;
    best_epoch = epoch;
    best->net = net;
  }
  return Classifier(std::move(best), best_epoch);
}

std::vector<std::vector<double>> Classifier::probabilities(std::span<const Row> rows) const {
  if (rows.empty()) return {};
  std::vector<Input> inputs;
  for (const Row& row : rows) inputs.push_back(network_->standardise(row));
  dlib::resizable_tensor tensor;
  network_->net.to_tensor(inputs.begin(), inputs.end(), tensor);
  const dlib::tensor& outputs = network_->net.subnet().forward(tensor);
  dlib::resizable_tensor softmax;
  softmax.copy_size(outputs);
  dlib::tt::softmax(softmax, outputs);
  std::vector<Row> result;
  const float* values = softmax.host();
  for (std::size_t i = 0; i < rows.size(); ++i, values += softmax.k()) {
    result.emplace_back(values, values + softmax.k());
  }
  return result;
}

std::vector<std::size_t> Classifier::predict(std::span<const Row> rows) const {
  std::vector<std::size_t> classes;
  for (const Row& row : probabilities(rows)) {
    classes.push_back(std::ranges::max_element(row) - row.begin());
  }
  return classes;
}

}  // namespace mdbd
