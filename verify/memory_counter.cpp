// Replaces the global allocation functions by ones that count. All of them stand on malloc and
// free, so that any form of `new` goes with any form of `delete`, with and without sanitizers.
#include <verify/memory_counter.hpp>

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace patchproof {

namespace {

// Allocation starts before main and goes on after it; constant-initialised variables are there.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
constinit std::atomic<std::ptrdiff_t> bytes{0};
// What a thread has not added yet; adding each block would take longer than allocating it.
constinit thread_local std::ptrdiff_t bytes_of_thread = 0;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)
constexpr std::ptrdiff_t most_of_thread = 1 << 16;

void count(std::ptrdiff_t change) {
  bytes_of_thread += change;
  if (bytes_of_thread < most_of_thread && bytes_of_thread > -most_of_thread) return;
  bytes.fetch_add(bytes_of_thread, std::memory_order_relaxed);
  bytes_of_thread = 0;
}

std::ptrdiff_t size_of(void* block) {
  return static_cast<std::ptrdiff_t>(malloc_usable_size(block));
}

void* counted(void* block) {
  if (block != nullptr) count(size_of(block));
  return block;
}

void* attempt(std::size_t size, std::size_t alignment) {
  if (size == 0) size = 1;
  if (alignment <= alignof(std::max_align_t)) return counted(std::malloc(size));
  void* block = nullptr;
  return posix_memalign(&block, alignment, size) == 0 ? counted(block) : nullptr;
}

void* allocated(std::size_t size, std::size_t alignment) {
  for (;;) {
    if (void* block = attempt(size, alignment)) return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc{};
    handler();
  }
}

void* allocated_or_null(std::size_t size, std::size_t alignment) noexcept {
  try {
    return allocated(size, alignment);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void release(void* block) noexcept {
  if (block == nullptr) return;
  count(-size_of(block));
  std::free(block);
}

constexpr std::size_t usual = alignof(std::max_align_t);
std::size_t as_number(std::align_val_t alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

std::size_t allocated_bytes() {
  const std::ptrdiff_t all = bytes.load(std::memory_order_relaxed) + bytes_of_thread;
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(all, 0));
}

}  // namespace patchproof

using patchproof::allocated;
using patchproof::allocated_or_null;
using patchproof::as_number;
using patchproof::release;
using patchproof::usual;
using Alignment = std::align_val_t;
using NoThrow = std::nothrow_t;

void* operator new(std::size_t size) { return allocated(size, usual); }
void* operator new[](std::size_t size) { return allocated(size, usual); }
void* operator new(std::size_t size, Alignment a) { return allocated(size, as_number(a)); }
void* operator new[](std::size_t size, Alignment a) { return allocated(size, as_number(a)); }
void* operator new(std::size_t size, const NoThrow&) noexcept {
  return allocated_or_null(size, usual);
}
void* operator new[](std::size_t size, const NoThrow&) noexcept {
  return allocated_or_null(size, usual);
}
void* operator new(std::size_t size, Alignment a, const NoThrow&) noexcept {
  return allocated_or_null(size, as_number(a));
}
void* operator new[](std::size_t size, Alignment a, const NoThrow&) noexcept {
  return allocated_or_null(size, as_number(a));
}

void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, Alignment) noexcept { release(block); }
void operator delete[](void* block, Alignment) noexcept { release(block); }
void operator delete(void* block, std::size_t, Alignment) noexcept { release(block); }
void operator delete[](void* block, std::size_t, Alignment) noexcept { release(block); }
void operator delete(void* block, const NoThrow&) noexcept { release(block); }
void operator delete[](void* block, const NoThrow&) noexcept { release(block); }
void operator delete(void* block, Alignment, const NoThrow&) noexcept { release(block); }
void operator delete[](void* block, Alignment, const NoThrow&) noexcept { release(block); }
