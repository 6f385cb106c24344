import { readPosition, type Position } from './frames';
import type { Inspected } from './inspected';
import type { LineEvent, StopRule } from './line-watch';

/** A line at which a program shall stop. */
export interface BreakPoint {
  readonly file: string;
  readonly line: number;
}

/** How to go on from where a program stands. */
export type Step = 'into' | 'over' | 'out';

/** A step by lines: a kind of step, or up to a line. */
export type LineStep = Step | BreakPoint;

/** Stops at the n-th time that a line begins. */
export function atLine({ file, line }: BreakPoint, hit = 1): StopRule {
  let left = hit;
  const rule = (event: LineEvent): boolean =>
    event.kind === 'line' && event.line === line && event.file === file && --left === 0;
  return Object.assign(rule, { only: [{ file, line }] });
}

/** Stops at each of these lines. */
export function atBreakPoints(points: readonly BreakPoint[]): StopRule {
  const files = new Map<number, Set<string>>();
  for (const { file, line } of points) files.set(line, (files.get(line) ?? new Set()).add(file));
  const rule = ({ kind, file, line }: LineEvent): boolean => kind === 'line' && files.get(line)?.has(file) === true;
  return Object.assign(rule, { only: points });
}

/**
 * Stops after one step from a position; `null`: from before the program. *Over* leaves out what the line calls, and what
 * is called from outside meanwhile; *out* goes on until the function has returned. A step at a function's end leads back
 * into the line that has called it.
 */
export function afterStep(step: Step, from: Position | null): StopRule {
  const depth = from?.depth ?? 0;
  return (event) => {
    if (event.depth < depth) return true;
    if (step === 'out' || event.kind === 'return') return false;
    return step === 'into' || event.depth === depth;
  };
}

/** The rule for a step from where the program stands. */
export function ruleOf(step: LineStep, vm: Inspected): StopRule {
  return typeof step === 'string' ? afterStep(step, readPosition(vm)) : atLine(step);
}
