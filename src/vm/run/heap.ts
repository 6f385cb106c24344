import type { Firmware } from './firmware';
import type { Memory } from './values';

/** MicroPython py/gc.c: blocks of 16 bytes, two bits for each in a table at the heap's start. */
const BLOCK_BYTES = 16;
/** The last word of the C stack, where the collector finds the reserve. The firmware knows it, too (../firmware/transform.mjs). */
const ROOT_BYTES = 4;
const Kind = { FREE: 0, HEAD: 1, TAIL: 2, MARK: 3 } as const;

/**
 * The device's heap: 64 KiB, of which 64512 bytes are blocks (py/gc.c) and some hundred are taken before the program
 * begins. Chosen so that the program measured in micropython-microbit-v2 issue #146 starts with the same 63984 bytes.
 */
const PROGRAM_BLOCKS = 4022;
/** Total size of the device's heap: `gc.mem_free()` and `gc.mem_alloc()` together. */
const DEVICE_BYTES = 64_512;
/**
 * Room for errors when the heap is full: the message, the traceback, and the library's report. Chosen; together with
 * the program's blocks a multiple of eight (../firmware/program-alone.mjs).
 */
const RESERVE_BLOCKS = 258;

/** True if one of the four kinds in this byte of the table is FREE (two zero bits). */
const hasFree = (kinds: number): boolean => ((kinds | (kinds >> 1)) & 0x55) !== 0x55;

/** The figures of `micropython.mem_info()`. */
export interface HeapInfo {
  readonly totalBytes: number;
  readonly usedBytes: number;
  readonly freeBytes: number;
  /** Number of objects of one block, and of two. */
  readonly oneBlock: number;
  readonly twoBlocks: number;
  /** The longest run of used and of free blocks. */
  readonly longestUsed: number;
  readonly longestFree: number;
}

/**
 * The collector's heap seen from outside: our library below, the reserve and the program's part above it.
 *
 * The reserve is a block that nothing in Python holds. The C function that raises a MemoryError frees it. It is taken
 * back here after the next collection that finds all of it free again, so that the program's part never grows.
 */
export class Heap {
  private reserve = 0;
  private isHeld = true;
  private isSealed = false;
  /** Start of the table of kinds, with which the heap begins: two bits for each block. */
  private tableStart = 0;
  /**
   * Start of the blocks. Together with the finaliser table of half its size and the blocks, one byte of the table of
   * kinds stands for 65.5 bytes of heap.
   */
  private poolStart = 0;

  constructor(
    private readonly firmware: Firmware,
    private readonly memory: Memory,
  ) {}

  /** Divides the empty heap: everything from here on belongs to the reserve and the program. */
  divide(): void {
    const [start, end] = [this.firmware.heap_start.value, this.firmware.heap_end.value];
    const tableBytes = Math.floor(((end - start - 1) * 2) / 131) & ~1;
    this.tableStart = start;
    this.poolStart = end - tableBytes * 64;
    this.firmware.program_start.value = this.firmware.heap_end.value - (PROGRAM_BLOCKS + RESERVE_BLOCKS) * BLOCK_BYTES;
  }

  /**
   * Fills the free blocks of the library's part, so that every program finds the same empty heap above it and none of
   * its code lies below. What is there now stays (../firmware/program-alone.mjs); what the library itself gives back
   * later is filled after the next collection.
   */
  seal(): void {
    this.isSealed = true;
    const end = this.blockAt(this.firmware.program_start.value);
    let length = 0;
    for (let block = end - 1; block >= 0; block--) {
      // Nearly always all four kinds in a byte are taken: this is run after every collection.
      if (length === 0 && block % 4 === 3 && !hasFree(this.memory.bytes[this.tableStart + (block >> 2)] ?? 0)) {
        block -= 3;
        continue;
      }
      if (this.kind(block) !== Kind.FREE) continue;
      length++;
      const isFirst = block === 0 || this.kind(block - 1) !== Kind.FREE;
      this.setKind(block, isFirst ? Kind.HEAD : Kind.TAIL);
      if (!isFirst) continue;
      const gap = this.poolStart + block * BLOCK_BYTES;
      this.memory.bytes.fill(0, gap, gap + length * BLOCK_BYTES);
      if (block + length === end) this.endLibrary(gap);
      length = 0;
    }
    this.endLibrary(this.firmware.program_start.value);
  }

  /** Sets the library's end, unless it is set already. */
  private endLibrary(address: number): void {
    if (this.firmware.library_end.value === 0) this.firmware.library_end.value = address;
  }

  /** Number of bytes of the block that becomes the reserve. */
  get reserveBytes(): number {
    return RESERVE_BLOCKS * BLOCK_BYTES;
  }

  /** Makes this allocated block the reserve; nothing else has to hold it. */
  setReserve(address: number): void {
    this.reserve = address;
    this.arm();
  }

  /** Frees the reserve now, for a report on a full heap; `hold` allows it to be taken back. */
  giveReserve(): void {
    this.isHeld = false;
    if (!this.isArmed) return;
    this.firmware.reserve.value = 0;
    this.setRoot(0);
    this.eachReserveBlock((block) => this.setKind(block, Kind.FREE));
  }

  hold(): void {
    this.isHeld = true;
  }

  /** The collector has run: fills what has died in the library's part, and takes the reserve back if possible. */
  collected(): void {
    if (this.isSealed) this.seal();
    if (!this.reserve || this.isArmed || !this.isHeld) return;
    let isFree = true;
    this.eachReserveBlock((block) => (isFree &&= this.kind(block) === Kind.FREE));
    if (!isFree) return;
    const first = this.blockAt(this.reserve);
    this.eachReserveBlock((block) => this.setKind(block, block === first ? Kind.HEAD : Kind.TAIL));
    this.arm();
  }

  /** True for the address of an object in the heap. */
  isObject(address: number): boolean {
    if (address % BLOCK_BYTES !== 0 || address < this.poolStart || address >= this.firmware.heap_end.value)
      return false;
    const kind = this.kind(this.blockAt(address));
    return kind === Kind.HEAD || kind === Kind.MARK;
  }

  /** The bytes of the object at this address; 0: there is none any more. */
  sizeOf(address: number): number {
    if (!this.isObject(address)) return 0;
    const first = this.blockAt(address);
    const end = this.blockAt(this.firmware.heap_end.value);
    let next = first + 1;
    while (next < end && this.kind(next) === Kind.TAIL) next++;
    return (next - first) * BLOCK_BYTES;
  }

  /** The result of `gc.mem_free()`, without running anything. */
  get freeBytes(): number {
    return this.info().freeBytes;
  }

  info(): HeapInfo {
    const counts = { free: 0, oneBlock: 0, twoBlocks: 0, longestUsed: 0, longestFree: 0 };
    let run = 0;
    let last: number = Kind.TAIL;
    const endRun = (): void => {
      if (last === Kind.FREE) counts.longestFree = Math.max(counts.longestFree, run);
      else {
        counts.longestUsed = Math.max(counts.longestUsed, run);
        if (run === 1) counts.oneBlock++;
        if (run === 2) counts.twoBlocks++;
      }
    };
    const start = this.blockAt(this.firmware.program_start.value);
    for (let block = start; block < this.blockAt(this.firmware.heap_end.value); block++) {
      const kind = this.kind(block);
      if (kind === Kind.FREE) counts.free++;
      const goesOn = kind === Kind.FREE ? last === Kind.FREE : kind === Kind.TAIL;
      if (goesOn) run++;
      else {
        if (run > 0) endRun();
        run = 1;
        last = kind;
      }
    }
    endRun();
    // While the reserve is free, the program does not gain by it.
    const free = Math.max(0, counts.free - (this.isArmed ? 0 : RESERVE_BLOCKS)) * BLOCK_BYTES;
    return { ...counts, totalBytes: DEVICE_BYTES, usedBytes: DEVICE_BYTES - free, freeBytes: free };
  }

  private get isArmed(): boolean {
    return this.firmware.reserve.value !== 0;
  }

  private arm(): void {
    this.firmware.reserve.value = this.reserve;
    this.setRoot(this.reserve);
  }

  /** The collector takes it for a pointer like all other words of the C stack. */
  private setRoot(address: number): void {
    this.memory.setWord(this.firmware.stack_base.value - ROOT_BYTES, address);
  }

  private eachReserveBlock(visit: (block: number) => void): void {
    const first = this.blockAt(this.reserve);
    for (let block = first; block < first + RESERVE_BLOCKS; block++) visit(block);
  }

  private blockAt(address: number): number {
    return (address - this.poolStart) / BLOCK_BYTES;
  }

  private kind(block: number): number {
    return ((this.memory.bytes[this.tableStart + (block >> 2)] ?? 0) >> (2 * (block & 3))) & 3;
  }

  private setKind(block: number, kind: number): void {
    const place = this.tableStart + (block >> 2);
    const shift = 2 * (block & 3);
    this.memory.bytes[place] = ((this.memory.bytes[place] ?? 0) & ~(3 << shift)) | (kind << shift);
  }
}
