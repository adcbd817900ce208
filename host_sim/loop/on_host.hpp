// An app's controller on the host, in lock-step: the same source as in the image.
#pragma once

#include <host_sim/loop/controllers.hpp>

namespace host_sim::loop {

template <class App>
class OnHost : public Controller {
 public:
  link::Torque answer(const link::Measurement& measurement, const link::SetPoint& wanted) override {
    link::Torque torque{};
    app_.measure(measurement);
    app_.load(wanted);
    app_.compute();
    app_.settle(wanted);
    app_.store(torque);
    return torque;
  }
  const App& app() const { return app_; }

 private:
  App app_;
};

}  // namespace host_sim::loop
