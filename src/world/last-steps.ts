import type { Chassis, Stance } from './chassis';

/** A robot as it was after a step of the world. */
interface Past {
  readonly stance: Stance;
  /** The clock of its program then. */
  readonly us: number;
}

/** The last steps of a robot, so that its sensors need not look after each of them. */
export class LastSteps {
  private readonly kept: Past[] = [];
  private steps = 0;

  /** @param most number of steps that are kept */
  constructor(
    private readonly chassis: Chassis,
    private readonly nowUs: () => number,
    private readonly most: number,
  ) {}

  /** Call it after each step of the world. */
  note(): void {
    this.kept[this.steps++ % this.most] = { stance: this.chassis.stance(), us: this.nowUs() };
  }

  /** The robot after a step: the last one is 0 steps ago. Throws RangeError if it is not kept. */
  ago(steps: number): Past {
    const past = steps < this.most ? this.kept[(this.steps - 1 - steps) % this.most] : undefined;
    if (past === undefined) throw new RangeError(`No step is kept that was ${steps} steps ago.`);
    return past;
  }
}
