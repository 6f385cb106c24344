import { radOf } from '#core/angle';
import { optionOf, type Option, type OptionValues } from '#core/option';
import type { Cone } from '#world/probes/distance-cone';
import robotWords from './words';

const words = robotWords.incidence;

/**
 * The option for the largest angle, from a wall's normal, at which a robot's ultrasonic sensor hears the wall. Beyond,
 * the sound is thrown elsewhere. 25°: measured in a thesis at ETH Zürich. 45°: chosen, between that and the ideal
 * sensor, which hears every wall.
 */
export const incidenceOption: Option = optionOf('incidence', words, ['all', '45', '25'], { isExpert: true });

/** The beam as the sensor hears it with this choice. */
export function heardCone(cone: Cone, { incidence = 'all' }: OptionValues): Cone {
  return incidence === 'all' ? cone : { ...cone, incidenceLimitRad: radOf(Number(incidence)) };
}
