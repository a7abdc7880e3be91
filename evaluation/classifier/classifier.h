#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace mdbd {

/// Rows of features with their classes.
struct LabelledRows {
  std::vector<std::vector<double>> rows;  ///< all of one length
  std::vector<std::size_t> labels;        ///< one for each row, counted from 0
};

/// Options of train_classifier(). The defaults had the best accuracy on the validation parts of 40
/// splits of 448 models, for 130 and for 100 features together.
struct ClassifierOptions {
  int hidden_neurons = 20;
  double learning_rate = 0.03;  ///< of Adam
  double weight_decay = 0.001;  ///< of Adam
  int batch_size = 32;          ///< rows of one step
  int maximum_epochs = 1000;
  int patience = 30;  ///< epochs without a lower validation loss after which training stops
};

/// A two-layer feed-forward network with sigmoid hidden and softmax output neurons (paper,
/// section 5.3). Its inputs are standardised as the training rows were.
class Classifier {
 public:
  ~Classifier();
  Classifier(Classifier&&) noexcept;
  Classifier& operator=(Classifier&&) noexcept;

  /// The probability of each class for each row; a row's sum to 1.
  /// @throws InvalidInput if a row is not as long as those of the training
  std::vector<std::vector<double>> probabilities(std::span<const std::vector<double>> rows) const;

  /// The most probable class of each row, the first of equal ones.
  /// @throws as probabilities
  std::vector<std::size_t> predict(std::span<const std::vector<double>> rows) const;

  int epochs() const { return epochs_; }  ///< of training, up to the weights that were kept

 private:
  struct Network;
  friend Classifier train_classifier(const LabelledRows&, const LabelledRows&, std::size_t,
                                     const ClassifierOptions&, std::uint64_t);
  Classifier(std::unique_ptr<Network> network, int epochs);

  std::unique_ptr<Network> network_;
  int epochs_;
};

/// Trains a network to minimise the cross-entropy of the training rows with Adam, in random order.
/// As in Matlab's patternnet, training ends when the loss of the validation rows has not fallen for
/// some epochs, and the weights of its lowest loss are kept. Without validation rows the training
/// rows judge. On one machine the result depends on the arguments alone.
/// @param class_count may exceed the classes that occur
/// @throws InvalidInput if there are no training rows, rows differ in length, a value is not
/// finite,
///         a label is not below class_count, or an option is not positive
Classifier train_classifier(const LabelledRows& training, const LabelledRows& validation,
                            std::size_t class_count, const ClassifierOptions& options,
                            std::uint64_t seed);

}  // namespace mdbd
