import type { Board } from '#board/board';
import type { Scope } from '../debug/inspected';
import { isSame } from '#core/same';
import type { Agreed } from './engine';
import type { Firmware } from './firmware';
import type { Memory } from './values';

/**
 * The facts that loading the library depends on: it asks the board, and which files there are. Neither time nor
 * chance matters.
 */
export interface LoadedFor {
  readonly module: WebAssembly.Module;
  readonly board: Pick<Board, 'type' | 'firmware'>;
  readonly fileNames: readonly string[];
}

/** Everything that the host received while the library was loaded. */
interface Heard {
  readonly agreed: Agreed;
  readonly scopes: ReadonlyMap<number, Scope>;
}

/** The effect of loading the library on a VM that was just started: the parts of its state that differ. */
export interface LibraryCopy extends Heard {
  readonly pages: readonly { readonly at: number; readonly bytes: Uint8Array }[];
  readonly globals: readonly { readonly name: string; readonly value: number }[];
}

/** The state of a VM before its library is loaded. */
export interface VmState {
  readonly bytes: Uint8Array;
  readonly globals: ReadonlyMap<string, number>;
}

const PAGE_BYTES = 4096;

/** Most copies of a module, of some 200 kB each. Chosen: boards and firmwares of a class, with main.py alone. */
const MOST_COPIES = 8;

interface Kept {
  readonly of: LoadedFor;
  readonly copy: LibraryCopy;
}

/** The newest last. */
const copies = new WeakMap<WebAssembly.Module, readonly Kept[]>();

/** The copy that suits a VM, or `null`. */
export function findCopy(wanted: LoadedFor): LibraryCopy | null {
  const kept = copies.get(wanted.module)?.find(({ of }) => suits(of, wanted));
  return kept?.copy ?? null;
}

const suits = (one: LoadedFor, other: LoadedFor): boolean =>
  one.board.type === other.board.type &&
  one.board.firmware === other.board.firmware &&
  isSame(one.fileNames, other.fileNames);

/** Records the state of a VM. */
export const stateOf = (firmware: Firmware, memory: Memory): VmState => ({
  bytes: memory.bytes.slice(),
  globals: new Map(globalsOf(firmware).map(([name, { value }]) => [name, value])),
});

/** Stores all that has changed in a VM since `before`. When there are too many copies, the oldest one is dropped. */
export function keepCopy(of: LoadedFor, before: VmState, firmware: Firmware, memory: Memory, heard: Heard): void {
  const copy: LibraryCopy = {
    agreed: heard.agreed,
    scopes: new Map(heard.scopes),
    pages: changedPages(before.bytes, memory.bytes),
    globals: globalsOf(firmware).flatMap(([name, { value }]) =>
      before.globals.get(name) === value ? [] : [{ name, value }],
    ),
  };
  const { type, firmware: ofBoard } = of.board; // the board itself would keep its run
  const kept = { of: { ...of, board: { type, firmware: ofBoard } }, copy };
  copies.set(of.module, [...(copies.get(of.module) ?? []).slice(1 - MOST_COPIES), kept]);
}

/** Gives a VM that was just started the loaded library. */
export function restoreCopy({ pages, globals }: LibraryCopy, firmware: Firmware, memory: Memory): void {
  for (const { at, bytes } of pages) memory.bytes.set(bytes, at);
  const byName = new Map(globalsOf(firmware));
  for (const { name, value } of globals) {
    const global = byName.get(name);
    if (global !== undefined) global.value = value;
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

function changedPages(before: Uint8Array, after: Uint8Array): LibraryCopy['pages'] {
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
