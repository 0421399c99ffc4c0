#include <thread>

namespace {

int shared = 0;

void count() {
  for (int i = 0; i < 1000; ++i) ++shared;
}

}  // namespace

// Two threads that count in one place without an order between them: what TSan has to say something about.
int main() {
  std::thread other(count);
  count();
  other.join();
}
