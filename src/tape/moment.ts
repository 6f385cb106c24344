import { msOf, robotReport, type RobotReport } from '#simulation/report';
import type { Simulation } from '#simulation/simulation';
import type { Shown } from '#vm/debug/shown';
import { readVariables, type Variable } from '#vm/debug/variables';

/** A device at one moment of a run, as data: where its program is, its variables, its robot. */
export interface Moment {
  readonly timeMs: number;
  /** File of the innermost of its functions; `null`: the program does not run. */
  readonly file: string | null;
  readonly line: number | null;
  /** Innermost first. */
  readonly stack: readonly {
    readonly function: string;
    readonly file: string;
    readonly line: number;
    readonly locals: Readonly<Record<string, Shown>>;
  }[];
  readonly globals: Readonly<Record<string, Shown>>;
  readonly robot: RobotReport | null;
}

/** The moment at which a run stands now, for the device at this place. Nothing of the run changes. */
export function momentOf(simulation: Simulation, device = 0): Moment {
  const inspected = simulation.inspect(device);
  if (inspected === null) throw new RangeError(`There is no device ${device}.`);
  const { stack, globals } = readVariables(inspected);
  const snapshot = simulation.snapshot();
  const { robot } = device === 0 ? snapshot : (snapshot.others[device - 1] ?? snapshot);
  return {
    timeMs: msOf(simulation.timeOf(device)),
    file: stack[0]?.file ?? null,
    line: stack[0]?.line ?? null,
    stack: stack.map((entry) => ({ ...entry, locals: byName(entry.locals) })),
    globals: byName(globals),
    robot: robot && robotReport(robot),
  };
}

const byName = (variables: readonly Variable[]): Readonly<Record<string, Shown>> =>
  Object.fromEntries(variables.map(({ name, value }) => [name, value]));
