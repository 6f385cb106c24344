import { readFileSync } from 'node:fs';
import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import { check } from '#check/check';
import { hintKinds } from '#hint/changes/change';
import { withChange } from '#hint/changes/change';
import { hintFor, type Hint } from '#hint/hint';
import { USUAL_BUDGET } from '#hint/level';
import { hintText } from '#hint/say';
import { corpus, faulty, type Fault } from '#hint/testing/corpus';
import { readyProject } from '../src/cli/ready-courses';

/** The hint to a faulty program. */
export interface HintRow {
  readonly fault: Fault;
  /** `undefined`: it took too long. */
  readonly hint: Hint | null | undefined;
  readonly line: number;
  readonly cpuS: number;
  readonly text: string;
}

/** CPU time after which a search is given up here, in s: a hint that takes longer does not count as found. */
const MOST_CPU_S = 20;
/** Signs of progress between two looks at the clock of the CPU, which takes as long as some of them. */
const BEATS = 50;
class TooLong extends Error {}

function taskNamed(course: string): ClassTask {
  const project = readyProject(course);
  const read = project === null ? { problem: `no course "${course}"` } : taskOf(project);
  if ('problem' in read) throw new Error(read.problem);
  return read.task;
}

/** Asks for a hint to each faulty program with these words in its course or kind. */
export async function* hintRows(words: string): AsyncGenerator<HintRow> {
  const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
  for (const fault of corpus) {
    if (!`${fault.course} ${fault.kind}`.includes(words)) continue;
    const { text, line } = faulty(readFileSync(`courses/${fault.course}/main.py`, 'utf8'), fault);
    const task = taskNamed(fault.course);
    const handIn = handInOfFiles([{ name: 'main.py', text }]);
    const start = process.cpuUsage();
    const cpuS = (): number => (process.cpuUsage(start).user + process.cpuUsage(start).system) / 1e6;
    let hint: Hint | null | undefined;
    let beats = 0;
    const beat = (): void => {
      beats += 1;
      if (beats % BEATS === 0 && cpuS() > MOST_CPU_S) throw new TooLong();
    };
    try {
      hint = await hintFor(task, handIn, { firmware, budget: USUAL_BUDGET, beat });
    } catch (error) {
      if (!(error instanceof TooLong)) throw error;
    }
    if (hint?.change) {
      const mended = handInOfFiles([{ name: 'main.py', text: withChange(text, hint.change) }]);
      if (!(await check(task, mended, { firmware })).passed) throw new Error('A hint does not hold.');
    }
    yield { fault, hint, line, cpuS: cpuS(), text: hint ? hintText(hint, 3, 'de') : '' };
  }
}

/** A row as a line: the fault, the change that was found, tries and CPU seconds, what a pupil reads at level 3. */
export function hintLine({ fault, hint, line, cpuS, text }: HintRow): string {
  const head = `${fault.course} ${fault.kind} line ${line}`;
  if (hint === null) return `${head}: passes, it is no fault`;
  if (hint === undefined) return `${head}: not within ${String(MOST_CPU_S)} s`;
  const { change, tried } = hint;
  const found = change === null ? 'nothing' : `${change.kind} line ${change.line} ${JSON.stringify(change.after)}`;
  return `${head}: ${found}, ${tried} tries, ${cpuS.toFixed(1)} s | ${text}`;
}

/** A table of kinds: how many of them were found, and how long it took. */
export function hintSums(rows: readonly HintRow[]): readonly string[] {
  const faulty = rows.filter(({ hint }) => hint !== null);
  const sum = (name: string, some: readonly HintRow[]): string => {
    const found = some.filter(({ hint, cpuS }) => hint?.change && cpuS <= MOST_CPU_S);
    const same = found.filter(({ hint, fault }) => hint?.change?.kind === fault.kind);
    const there = found.filter(({ hint, line }) => Math.abs((hint?.change?.line ?? 0) - line) <= 1);
    const seconds = some.map(({ cpuS }) => cpuS).sort((one, other) => one - other);
    const [middle, most] = [seconds[seconds.length >> 1] ?? 0, seconds.at(-1) ?? 0];
    return `${name.padEnd(12)} found ${found.length}/${some.length}, of its kind ${same.length}, in its line ${there.length}, CPU median ${middle.toFixed(1)} s, most ${most.toFixed(1)} s`;
  };
  const kinds = hintKinds.map((kind) => sum(kind, faulty.filter(({ fault }) => fault.kind === kind))); // prettier-ignore
  return [...kinds, sum('all', faulty)];
}
