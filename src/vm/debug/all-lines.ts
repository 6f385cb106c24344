import { entersLine, ownCode, STATE, type OwnCode } from './frames';
import type { Inspected } from './inspected';
import type { LineEvent, LineFinder } from './line-event';
import { begins, rangeAt, type LineRange } from './lines';
import { Names } from './names';

/** A running function at the last look. */
interface Seen {
  readonly state: number;
  readonly functionAt: number;
  /** `null`: it is not the pupil's. */
  readonly code: OwnCode | null;
  range: LineRange;
  at: number;
}

const NOWHERE: LineRange = { line: 0, from: 0, to: 0, start: 0 };

/** Finds every line that begins or resumes: it compares the running functions from bytecode to bytecode. */
export class AllLines implements LineFinder {
  private readonly names: Names;
  private readonly seen: Seen[] = [];

  constructor(readonly vm: Inspected) {
    this.names = new Names(vm.memory, vm.interned);
  }

  start(): void {
    this.vm.scopes.heard = null;
    this.vm.marks.begin(true);
    this.see(this.vm.framesEnd());
  }

  next(): LineEvent | null {
    const { memory, framesStart } = this.vm;
    const { seen } = this;
    const end = this.vm.framesEnd();
    const state = memory.word(end - 4);
    const functionAt = memory.word(state + STATE.function);
    const depth = (end - framesStart) / 4;
    const last = seen[depth - 1];
    if (last?.state !== state || last.functionAt !== functionAt) return this.enter(end);
    const isBack = seen.length > depth;
    seen.length = depth;
    return this.goOn(last, memory.word(state + STATE.at), isBack);
  }

  /** @param isBack a call in the function has ended */
  private goOn(last: Seen, at: number, isBack: boolean): LineEvent | null {
    if (last.code === null) return null;
    const before = { at: last.at, line: last.range.line };
    const isSameRange = at >= last.range.from && at < last.range.to;
    last.at = at;
    if (!isSameRange) last.range = rangeAt(last.code.lines, at);
    const isBegun = at === last.range.start && begins(last.range, at, before);
    if (isBegun || entersLine(last.code, at, before.at)) return this.event('line', last);
    return isBack ? this.event('return', last) : null;
  }

  /** A function begins, or a generator goes on. */
  private enter(end: number): LineEvent | null {
    const innermost = this.see(end);
    if (!innermost?.code) return null;
    const { code, at, range } = innermost;
    return at === range.start || entersLine(code, at, at) ? this.event('line', innermost) : null;
  }

  /** Brings the list of functions up to date. @returns the innermost */
  private see(end: number): Seen | undefined {
    const { memory, framesStart } = this.vm;
    const { seen } = this;
    for (let place = 0, at = framesStart; at < end; place++, at += 4) {
      const state = memory.word(at);
      const functionAt = memory.word(state + STATE.function);
      if (seen[place]?.state === state && seen[place]?.functionAt === functionAt && at < end - 4) continue;
      seen.length = place;
      seen.push(this.read(state, functionAt));
    }
    seen.length = (end - framesStart) / 4;
    return seen.at(-1);
  }

  private read(state: number, functionAt: number): Seen {
    const { memory } = this.vm;
    const code = ownCode(this.vm, this.names, state);
    const at = memory.word(state + STATE.at);
    return { state, functionAt, code, at, range: code ? rangeAt(code.lines, at) : NOWHERE };
  }

  private event(kind: LineEvent['kind'], { code, range }: Seen): LineEvent {
    let depth = -1;
    for (const each of this.seen) if (each.code !== null) depth++;
    return { kind, file: code?.file ?? '', line: range.line, depth };
  }
}
