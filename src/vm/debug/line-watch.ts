import type { Watch } from '../run/engine';
import { AllLines } from './all-lines';
import { STATE } from './frames';
import type { Inspected } from './inspected';
import type { LineFinder, StopRule } from './line-event';
import { MarkedLines } from './marked-lines';

export type { LineEvent, StopRule } from './line-event';

/**
 * Follows a program from line to line, for `Hold.watch`.
 *
 * @param inspect the MicroPython that runs now; a reset of the board starts another one
 */
export function watchLines(inspect: () => Inspected, rule: StopRule): Watch {
  const { only } = rule;
  const finderFor = (vm: Inspected): LineFinder => (only ? new MarkedLines(vm, only) : new AllLines(vm));
  let finder: LineFinder | null = null;
  let standing: Standing | null = null;
  return {
    begin(isNew) {
      const vm = inspect();
      if (!isNew && finder?.vm === vm) return;
      finder = finderFor(vm);
      finder.start();
      standing = standingOf(vm);
    },
    passed: () => void (standing = null),
    look(catchUp) {
      if (finder === null) return false;
      const passed = standing;
      standing = null;
      if (passed !== null) {
        const here = standingOf(finder.vm);
        if (here?.state === passed.state && here.at === passed.at) return false;
      }
      const event = finder.next();
      if (event === null) return false;
      catchUp();
      return rule(event);
    },
  };
}

/** The innermost function, and the bytecode that is next in it. */
interface Standing {
  readonly state: number;
  readonly at: number;
}

function standingOf(vm: Inspected): Standing | null {
  const { memory, framesStart } = vm;
  const innermost = vm.framesEnd() - 4;
  if (innermost < framesStart) return null;
  const state = memory.word(innermost);
  return { state, at: memory.word(state + STATE.at) };
}
