/** Fitting a measured robot, in a worker of its own: seconds of simulated driving that the page need not wait for. */
import { findRobot } from '#robots/index';
import type { Traits } from '#robots/traits';
import { fitTraits } from '#my-robot/fit';
import type { Measured } from '#my-robot/my-robot';
import { predictMotion, type Motion } from '#my-robot/predict';

/** From the page: the measurements of a robot of this type. */
export interface FitRequest {
  readonly type: 'fit';
  readonly firmware: WebAssembly.Module;
  /** Id of the robot's type. */
  readonly robot: string;
  readonly measured: Measured;
}

/** The result: the traits, and the drives of the robot without and with them. */
export interface Fit {
  readonly traits: Traits;
  readonly before: Motion;
  readonly after: Motion;
}

/** To the page. */
export type FitAnswer =
  { readonly type: 'fitted'; readonly fit: Fit } | { readonly type: 'failed'; readonly message: string };

/** Answers a request; never rejects. */
export async function answerFit({ firmware, robot, measured }: FitRequest): Promise<FitAnswer> {
  try {
    const type = findRobot(robot);
    if (type === null) throw new RangeError(`There is no robot "${robot}".`);
    const traits = await fitTraits(measured, type, firmware);
    const before = await predictMotion({ type, firmware });
    const after = await predictMotion({ type, firmware, traits });
    return { type: 'fitted', fit: { traits, before, after } };
  } catch (error) {
    return { type: 'failed', message: error instanceof Error ? error.message : String(error) };
  }
}
