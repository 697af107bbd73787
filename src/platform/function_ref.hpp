// SPDX-License-Identifier: MIT
// A reference to a function object, which hides the type of the object.
#pragma once

#include <type_traits>

namespace mgdt {

template <class Signature>
class FunctionRef;
template <class... Arguments>
class FunctionRef<void(Arguments...)> {
  public:
    // A copy refers to the same function object.
    template <class F, class = std::enable_if_t<!std::is_same_v<std::remove_cv_t<F>, FunctionRef>>>
    FunctionRef(F& f) noexcept  // NOLINT: meant to convert
        : object_(const_cast<void*>(static_cast<const void*>(&f))),
          call_([](void* object, Arguments... arguments) {
              (*static_cast<F*>(object))(arguments...);
          }) {}
    void operator()(Arguments... arguments) const { call_(object_, arguments...); }

  private:
    void* object_;
    void (*call_)(void*, Arguments...);
};

}  // namespace mgdt
