// An app's controller on the host, in lock-step: the same source as in the image.
#pragma once

#include <host_sim/plants/loop/controllers.hpp>

#include <firmware/apps/feedforward/feedforward.hpp>

namespace host_sim::loop {

template <class App>
class OnHost : public Controller {
 public:
  void take(const link::Derivatives& derivatives) override {
    if constexpr (axial::apps::takes_derivatives<App>) app_.take(derivatives);
  }
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
