// Replaces the global allocation functions by ones that count. All of them stand on malloc and
// free, so that any form of `new` goes with any form of `delete`, with and without sanitizers.
#include <verify/memory_counter.hpp>

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace patchproof {

namespace {

// Allocation starts before main and goes on after it; a constant-initialised atomic is there.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
constinit std::atomic<std::size_t> bytes{0};

void* counted(void* block) {
  if (block != nullptr) bytes.fetch_add(malloc_usable_size(block), std::memory_order_relaxed);
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
  bytes.fetch_sub(malloc_usable_size(block), std::memory_order_relaxed);
  std::free(block);
}

constexpr std::size_t usual = alignof(std::max_align_t);
std::size_t as_number(std::align_val_t alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

std::size_t allocated_bytes() { return bytes.load(std::memory_order_relaxed); }

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
