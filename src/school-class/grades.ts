/** Grades of a school system. */
interface System {
  /** Grade for no points, and for all. */
  readonly worst: number;
  readonly best: number;
  /** The worst grade that is a pass. */
  readonly pass: number;
  /** Step to which grades are rounded if nothing else is chosen. */
  readonly step: number;
}

/**
 * The systems that there are, by their ids. Their ends and passes are those of the schools: Switzerland 1 to 6 (4 passes),
 * Germany 6 to 1 (4 passes) and 0 to 15 points (5 pass), France 0 to 20 (10 passes), Italy 0 to 10 (6 passes). Steps are chosen.
 */
export const systems = {
  ch6: { worst: 1, best: 6, pass: 4, step: 0.5 },
  de6: { worst: 6, best: 1, pass: 4, step: 0.5 },
  de15: { worst: 0, best: 15, pass: 5, step: 1 },
  fr20: { worst: 0, best: 20, pass: 10, step: 0.5 },
  it10: { worst: 0, best: 10, pass: 6, step: 0.5 },
} as const satisfies Readonly<Record<string, System>>;
export type SystemId = keyof typeof systems;
export const systemIds = Object.keys(systems) as readonly SystemId[];

/** Steps to which grades may be rounded. */
export const gradeSteps = [1, 0.5, 0.25, 0.1] as const;

/** How points become grades. */
export interface Scale {
  readonly system: SystemId;
  /** Share of the points from which it is a pass, in per cent; `null`: grades rise evenly from no points to all. */
  readonly passPercent: number | null;
  readonly step: (typeof gradeSteps)[number];
}

/** Share of the points for a pass that may be chosen, in per cent. */
export const passPercents = { min: 1, max: 99 } as const;

/** The usual scale of a system: even. */
export const usualScale = (system: SystemId): Scale => ({ system, passPercent: null, step: systems[system].step });

/** The best grade of a scale. */
export const bestGrade = ({ system }: Scale): number => systems[system].best;

/**
 * The grade for so many points of so many; a half step goes to the better grade. `null` where there are no points to have.
 */
export function gradeOf({ system, passPercent, step }: Scale, points: number, of: number): number | null {
  if (of <= 0) return null;
  const { worst, best, pass } = systems[system];
  const [range, passed] = [best - worst, (pass - worst) / (best - worst)];
  const share = Math.min(1, Math.max(0, points / of));
  const least = passPercent === null ? passed : passPercent / 100;
  const risen = share < least ? (share / least) * passed : passed + ((share - least) / (1 - least)) * (1 - passed);
  const steps = Math.floor((risen * Math.abs(range)) / step + 0.5 + ROUNDING);
  return Math.round((worst + Math.sign(range) * steps * step) * 100) / 100;
}

/** A half that a division has missed by its last bits is a half. */
const ROUNDING = 1e-9;
