#pragma once
namespace halsted::app {

inline constexpr const char* kVersionText = "halsted 0.1.0";

}  // namespace halsted::app
