#pragma once
/// Who makes an arm's steps: this core, at once, or one beside it that its board has (hal/rp2040/board.hpp).

#include <type_traits>

namespace axial::apps::plant {

struct OnThisCore {
  static constexpr bool is_beside = false;
  static void start() {}
  static void begin(void (*job)(void*), void* with) { job(with); }
  static void join() {}
  static bool stack_intact() { return true; }
};

/// A board's Worker, where it has one: start(), begin(job, with) of one job at a time, join(), stack_intact().
template <class BoardsOwn>
struct Beside : BoardsOwn {
  static constexpr bool is_beside = true;
};

template <class Board, class = void>
struct WorkerOfBoard {
  using type = OnThisCore;
};
template <class Board>
struct WorkerOfBoard<Board, std::void_t<typename Board::Worker>> {
  using type = Beside<typename Board::Worker>;
};
template <class Board>
using WorkerOf = typename WorkerOfBoard<Board>::type;

}  // namespace axial::apps::plant
