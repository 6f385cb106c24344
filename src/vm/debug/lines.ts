import type { Memory } from '../run/values';
import { readInstructions, type Instruction } from './instructions';

/** Bytecodes that belong to one line of source. */
export interface LineRange {
  readonly line: number;
  /** Addresses: from the first up to, not including, the last. */
  readonly from: number;
  readonly to: number;
  /** The address where the line begins; at another address it resumes. */
  readonly start: number;
  /** A loop comes back to here: with each round the line begins anew. */
  readonly isLoop?: boolean;
  /** Address of the jump that enters the loop; coming from anywhere else, the line begins anew. */
  readonly entry?: number;
}

/** The addresses of a function's table of line numbers and of its bytecodes. */
export interface CodePlace {
  readonly table: { readonly start: number; readonly end: number };
  readonly first: number;
}

/** The range in which an address lies. */
export function rangeAt(ranges: readonly LineRange[], address: number): LineRange {
  for (const range of ranges) if (address < range.to) return range;
  return { line: 1, from: address, to: Infinity, start: address };
}

/**
 * The lines of a function's bytecodes, in the order of the addresses.
 *
 * The table that MicroPython keeps never goes back. But the condition of a `while` and the counting of a `for` come after
 * the loop's body, and there the table names the body's last line. The jumps show which bytecodes these are.
 */
export function readLines(memory: Memory, place: CodePlace): readonly LineRange[] {
  let ranges = readTable(memory, place);
  const instructions = readInstructions(memory, place.first);
  for (const instruction of instructions) {
    const { kind, at, target } = instruction;
    if (target === null) continue;
    if (kind === 'jump' && target <= at) ranges = markLoop(ranges, target);
    else if (kind === 'jump') ranges = markCondition(ranges, instructions, instruction, target);
  }
  return ranges;
}

/** True if a line begins at this address, for a program that comes from another one. */
export function begins(ranges: LineRange, at: number, before: { readonly line: number; readonly at: number }): boolean {
  const { line, start, isLoop, entry } = ranges;
  if (at !== start) return false;
  if (line !== before.line) return true;
  return (isLoop === true && at < before.at) || (entry !== undefined && before.at !== entry);
}

/** py/bc.h: mp_bytecode_get_source_line. */
function readTable(memory: Memory, { table, first }: CodePlace): readonly LineRange[] {
  const ranges: LineRange[] = [];
  let line = 1;
  let [from, to] = [first, first];
  for (let at = table.start; at < table.end;) {
    const head = memory.byte(at);
    const isLong = (head & 0x80) !== 0;
    to += isLong ? head & 0xf : head & 0x1f;
    const lines = isLong ? ((head << 4) & 0x700) | memory.byte(at + 1) : head >> 5;
    at += isLong ? 2 : 1;
    // An entry of no lines: the line has more bytes than one entry can tell.
    if (lines === 0) continue;
    if (to > from) ranges.push({ line, from, to, start: from });
    line += lines;
    from = to;
  }
  return [...ranges, { line, from, to: Infinity, start: from }];
}

/** Makes a line begin anew at the target of the jump back of a `for` or of a `while True`. */
const markLoop = (ranges: readonly LineRange[], target: number): readonly LineRange[] =>
  ranges.flatMap((range) => {
    if (target < range.from || target >= range.to) return [range];
    const after = { ...range, from: target, start: target, isLoop: true };
    return target === range.from ? [after] : [{ ...range, to: target }, after];
  });

/** Gives a loop's condition its line. A jump to it enters the loop; the jump at its end leads back to the body. */
function markCondition(
  ranges: readonly LineRange[],
  instructions: readonly Instruction[],
  { at: entry, next: body }: Instruction,
  target: number,
): readonly LineRange[] {
  const back = instructions.findLast(({ kind, target: to }) => kind === 'jump-if-true' && to === body);
  if (back === undefined || back.at < target) return ranges;
  const from = countingBefore(instructions, target) ?? target;
  const { line } = rangeAt(ranges, entry);
  const to = back.next;
  const condition: LineRange = { line, from, to, start: from, entry };
  const before = ranges
    .filter((range) => range.from < from)
    .map((range) => ({ ...range, to: Math.min(range.to, from) }));
  const after = ranges.filter((range) => range.to > to).map((range) => ({ ...range, from: Math.max(range.from, to) }));
  return [...before, condition, ...after];
}

/** Address at which a `for` over a range adds its step, just before the condition; `null`: it is another loop. */
function countingBefore(instructions: readonly Instruction[], condition: number): number | null {
  const place = instructions.findIndex(({ at }) => at === condition);
  const [step, add] = instructions.slice(Math.max(place - 2, 0), Math.max(place, 0));
  return step?.kind === 'small-int' && add?.kind === 'add-in-place' ? step.at : null;
}
