import type { Firmware } from './firmware';
import type { Memory } from './values';

/** All of a VM's state while nothing of it is suspended. */
export interface VmState {
  readonly bytes: Uint8Array;
  readonly globals: ReadonlyMap<string, number>;
}

/** The parts of a VM's state that differ from another one: whole pages of its memory, and global variables. */
export interface StateChange {
  readonly pages: readonly { readonly at: number; readonly bytes: Uint8Array }[];
  readonly globals: readonly { readonly name: string; readonly value: number }[];
}

const PAGE_BYTES = 4096;

/** Records the state of a VM. */
export const stateOf = (firmware: Firmware, memory: Memory): VmState => ({
  bytes: memory.bytes.slice(),
  globals: new Map(globalsOf(firmware).map(([name, { value }]) => [name, value])),
});

/** All that has changed in a VM since `before`. */
export const changeSince = (before: VmState, firmware: Firmware, memory: Memory): StateChange => ({
  pages: changedPages(before.bytes, memory.bytes),
  globals: globalsOf(firmware).flatMap(([name, { value }]) =>
    before.globals.get(name) === value ? [] : [{ name, value }],
  ),
});

/** Brings a VM that is in the state before a change into the state after it. */
export function applyChange({ pages, globals }: StateChange, firmware: Firmware, memory: Memory): void {
  for (const { at, bytes } of pages) memory.bytes.set(bytes, at);
  const byName = new Map(globalsOf(firmware));
  for (const { name, value } of globals) {
    const global = byName.get(name);
    if (global !== undefined && global.value !== value) global.value = value; // some never change, and cannot be set
  }
}

/**
 * All global variables, and some that never change. Not `gas`: it depends on the alarms of the clock, and the engine
 * sets it whenever it enters the VM.
 */
const globalsOf = (firmware: Firmware): [string, WebAssembly.Global][] =>
  Object.entries(firmware).filter(
    (entry): entry is [string, WebAssembly.Global] => entry[0] !== 'gas' && entry[1] instanceof WebAssembly.Global,
  );

function changedPages(before: Uint8Array, after: Uint8Array): StateChange['pages'] {
  const [old, now] = [new Int32Array(before.buffer), new Int32Array(after.buffer)];
  const words = PAGE_BYTES / Int32Array.BYTES_PER_ELEMENT;
  const pages: { at: number; bytes: Uint8Array }[] = [];
  for (let word = 0; word < now.length; word++) {
    if (now[word] === old[word]) continue;
    const page = Math.floor(word / words);
    const at = page * PAGE_BYTES;
    pages.push({ at, bytes: after.slice(at, at + PAGE_BYTES) });
    word = (page + 1) * words - 1;
  }
  return pages;
}
