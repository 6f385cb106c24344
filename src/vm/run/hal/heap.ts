import { wholeOf } from '../arguments';
import type { Heap } from '../heap';
import type { SyscallTable } from '../syscall';

/**
 * Memory as the device's modules gc and micropython see it: the program's 64 KiB, without our library.
 *
 * - heap(what) → 0 all bytes, 1 used, 2 free, 3 objects of one block, 4 of two, 5 blocks of the longest object, 6
 *   longest run of free blocks
 */
export function createHeapCalls(heap: Heap): SyscallTable {
  return {
    heap: (what) => {
      const { totalBytes, usedBytes, freeBytes, oneBlock, twoBlocks, longestUsed, longestFree } = heap.info();
      return [totalBytes, usedBytes, freeBytes, oneBlock, twoBlocks, longestUsed, longestFree][wholeOf(what) ?? 0] ?? 0;
    },
  };
}
