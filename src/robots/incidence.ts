import { radOf } from '#core/angle';
import type { Option, OptionValues } from '#core/option';
import type { Cone } from '#world/probes/distance-cone';
import robotWords from './words';

const words = robotWords.incidence;

/**
 * The option for the largest angle, from a wall's normal, at which a robot's ultrasonic sensor hears the wall. Beyond,
 * the sound is thrown elsewhere. 25°: measured in a thesis at ETH Zürich. 45°: chosen, between that and the ideal
 * sensor, which hears every wall.
 */
export const incidenceOption: Option = {
  id: 'incidence',
  title: words.title,
  about: words.about,
  isExpert: true,
  choices: [
    { id: 'all', title: words.choices.all },
    { id: '45', title: words.choices['45'] },
    { id: '25', title: words.choices['25'] },
  ],
};

/** The beam as the sensor hears it with this choice. */
export function heardCone(cone: Cone, { incidence = 'all' }: OptionValues): Cone {
  return incidence === 'all' ? cone : { ...cone, incidenceLimitRad: radOf(Number(incidence)) };
}
