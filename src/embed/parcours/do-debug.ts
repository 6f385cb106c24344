import { msOf } from '#simulation/report';
import type { Variable } from '#vm/debug/variables';

import type { EmbeddedDebugger, ProgramMoment } from '../debugger';
import type { Refusal } from '../simulator';
import type { Position } from './protocol';
import type { ReadCommand } from './read-command';

/** Commands about a program's lines and a run's time. */
export type DebugCommand = Extract<
  ReadCommand,
  {
    type:
      | 'get-break-points'
      | 'set-break-points'
      | 'get-position'
      | 'step-line'
      | 'run-to'
      | 'look-at'
      | 'look-now'
      | 'go-on';
  }
>;

/** The outcome of a command: the fields of its answer, or the reason for its refusal. */
type Came = { readonly answer: object } | Refusal;

/** Carries out such a command. */
export function doDebug(command: DebugCommand, debug: EmbeddedDebugger): Came | Promise<Came> {
  switch (command.type) {
    case 'get-break-points': {
      const points = debug.breakPoints(command.fields.device);
      return typeof points === 'string' ? points : { answer: { points } };
    }
    case 'set-break-points':
      return debug.setBreakPoints(command.fields.points, command.fields.device);
    case 'get-position':
      return debug
        .moment(command.fields.device)
        .then((moment) => (typeof moment === 'string' ? moment : { answer: positionOf(moment) }));
    case 'step-line':
      return debug.step(command.fields.step, command.fields.device);
    case 'run-to': {
      const { file, line, device } = command.fields;
      return debug.step({ file, line }, device);
    }
    case 'look-at':
      return debug.lookAt(command.fields.atMs * 1000);
    case 'look-now':
      return debug.lookNow();
    case 'go-on':
      return debug.goOn(command.fields.paused ?? false);
    default:
      return command satisfies never;
  }
}

/** The form of `parcours replay --at … --json`, without the robot. */
function positionOf({ timeUs, variables: { stack, globals } }: ProgramMoment): Position {
  return {
    atMs: msOf(timeUs),
    file: stack[0]?.file ?? null,
    line: stack[0]?.line ?? null,
    stack: stack.map((entry) => ({ ...entry, locals: byName(entry.locals) })),
    globals: byName(globals),
  };
}

const byName = (variables: readonly Variable[]): Position['globals'] =>
  Object.fromEntries(variables.map(({ name, value }) => [name, value]));
