#include "input_queue.hpp"

namespace tyndall::editor {
namespace {

using Kind = InputEvent::Kind;

bool moves(const InputEvent& event) { return event.kind == Kind::kMotion || event.kind == Kind::kLeave; }

}  // namespace

std::vector<InputEvent> InputQueue::take() {
  if (events_.empty()) return {};
  std::vector<InputEvent> step{events_.front()};
  events_.pop_front();
  const auto next = [&](auto&& belongs) { return !events_.empty() && belongs(events_.front()); };
  const auto ofKind = [](Kind kind) { return [kind](const InputEvent& event) { return event.kind == kind; }; };
  switch (step.front().kind) {
    case Kind::kMotion:
    case Kind::kLeave:
      for (; next(moves); events_.pop_front()) step.front() = events_.front();
      break;
    case Kind::kWheel:
      for (; next(ofKind(Kind::kWheel)); events_.pop_front()) {
        step.front().at += events_.front().at;
        step.front().seconds = events_.front().seconds;
      }
      break;
    case Kind::kKey:
    case Kind::kText:
      for (; next(ofKind(Kind::kText)); events_.pop_front()) step.push_back(events_.front());
      break;
    case Kind::kButton: break;
  }
  return step;
}

bool InputQueue::pressNext() const {
  if (events_.empty()) return false;
  const InputEvent& first = events_.front();
  return (first.kind == Kind::kButton || first.kind == Kind::kKey) && first.down;
}

}  // namespace tyndall::editor
