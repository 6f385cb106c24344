import { codeOf } from './code';
import { entersLine, ownCode, readFrames, STATE, type OwnCode } from './frames';
import type { Inspected } from './inspected';
import { readInstructions } from './instructions';
import type { LineEvent, LineFinder } from './line-event';
import { begins, rangeAt } from './lines';
import { Names } from './names';

/** In place of an address or a line: the function has come from a line without marks. */
const ELSEWHERE = 0;

/**
 * Finds the beginnings of a few lines. The interpreter asks before their bytecodes and before those to which they lead,
 * and runs all others at full speed. So the line a function comes from is known only if it is one of these.
 */
export class MarkedLines implements LineFinder {
  private readonly names: Names;
  private readonly lines = new Map<string, Set<number>>();
  /** Code whose marks are set, by its address; `null`: it has none of the lines. */
  private readonly known = new Map<number, OwnCode | null>();
  /** The bytecode before which each function was seen last, by its code_state. */
  private readonly last = new Map<number, number>();

  constructor(
    readonly vm: Inspected,
    lines: readonly { readonly file: string; readonly line: number }[],
  ) {
    this.names = new Names(vm.memory, vm.interned);
    for (const { file, line } of lines) this.lines.set(file, (this.lines.get(file) ?? new Set()).add(line));
  }

  start(): void {
    const { vm } = this;
    vm.marks.begin(false);
    for (const code of vm.scopes.codes) this.expect(code);
    vm.scopes.heard = (code) => this.expect(code);
    for (let at = vm.framesStart; at < vm.framesEnd(); at += 4) this.find(vm.memory.word(at));
  }

  next(): LineEvent | null {
    const { memory } = this.vm;
    const state = memory.word(this.vm.framesEnd() - 4);
    const start = codeOf(memory, memory.word(state + STATE.function));
    const at = memory.word(state + STATE.at);
    const isFirst = !this.known.has(start);
    const code = isFirst ? this.learn(state, start) : (this.known.get(start) ?? null);
    if (code === null) return null;
    // Code that is met for the first time begins, or it is a generator that goes on.
    const before = isFirst ? at : (this.last.get(state) ?? ELSEWHERE);
    this.last.set(state, at);
    const range = rangeAt(code.lines, at);
    if (!this.isWanted(code, range.line)) return null;
    const isBegun =
      at === range.start && (isFirst || begins(range, at, { line: this.lineAt(code, before), at: before }));
    return isBegun || entersLine(code, at, before) ? this.event(code, range.line) : null;
  }

  /** Marks new code as a whole: before it runs, its file is not known. */
  private expect(start: number): void {
    this.known.delete(start);
    this.vm.marks.set(start, start + this.vm.sizeOf(start), true);
  }

  /** Takes in a function that runs already. */
  private find(state: number): void {
    const { memory } = this.vm;
    const start = codeOf(memory, memory.word(state + STATE.function));
    if (this.vm.scopeOf(start) === undefined) return;
    if (!this.known.has(start)) this.learn(state, start);
    this.last.set(state, memory.word(state + STATE.at));
  }

  /** Marks the wanted lines of code that runs for the first time. @returns the code; `null`: it has none of them */
  private learn(state: number, start: number): OwnCode | null {
    const { memory, marks } = this.vm;
    const own = ownCode(this.vm, this.names, state);
    const code = own?.lines.some(({ line }) => this.isWanted(own, line)) ? own : null;
    this.known.set(start, code);
    marks.set(start, start + this.vm.sizeOf(start), false);
    if (code === null) return null;
    const instructions = readInstructions(memory, code.place.first);
    const places = new Set(instructions.map(({ at }) => at));
    const mark = (at: number | null): void => {
      if (at !== null && places.has(at)) marks.set(at, at + 1, true);
    };
    mark(code.place.first); // from here on it is another call
    for (const { at, next, target, kind } of instructions) {
      if (kind === 'handler') mark(target);
      if (this.isWanted(code, this.lineAt(code, at))) [at, next, target].forEach(mark);
    }
    return code;
  }

  private isWanted({ file }: OwnCode, line: number): boolean {
    return this.lines.get(file)?.has(line) === true;
  }

  private lineAt({ lines, place }: OwnCode, at: number): number {
    return at < place.first ? ELSEWHERE : rangeAt(lines, at).line;
  }

  private event({ file }: OwnCode, line: number): LineEvent {
    return { kind: 'line', file, line, depth: readFrames(this.vm, this.names).length - 1 };
  }
}
