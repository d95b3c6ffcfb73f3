#pragma once
/// What a number on the command line may be.
#include <CLI/CLI.hpp>

namespace halsted::app {

/// A finite number from `least` to `most`, in the C locale. CLI::Range lets "nan" pass, which is in every range that is asked for by < and >.
CLI::Validator numberFrom(double least, double most);   // [unit of the option]

}  // namespace halsted::app
