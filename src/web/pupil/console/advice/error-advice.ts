import { adviceFor as adviceOf, type Advice as AdviceOf, type Failure } from '#advice/advice';
import type { Source } from '#advice/syntax-advice';

import type { TextKey, TextValues } from '../../../kit/i18n/texts';
import type { RobotInError } from '../../../session/work/hardware/misplugged';

export type { Failure } from '#advice/advice';

/** An explanation of an error in the pupil's language: a text's name and what goes into it. */
export interface Advice extends Omit<AdviceOf, 'key' | 'values'> {
  readonly key: TextKey;
  readonly values: TextValues;
}

/** All that an explanation is made of. */
export interface ErrorReport {
  readonly failure: Failure;
  /** The pupil's file and the line that the exception names. */
  readonly source: Source | null;
  readonly table: RobotInError | null;
}

/**
 * The explanation of an exception for pupils.
 *
 * @param table what is plugged in. With it, a robot that does not answer can be explained.
 */
export function adviceFor(failure: Failure, source: Source | null = null, table: RobotInError | null = null): Advice {
  const advice = adviceOf(failure, source);
  return table === null ? advice : { ...advice, ...atTable(advice, table) };
}

/** The reason why no robot or chip answers, from what is plugged in; other advice is unchanged. */
function atTable({ key, values }: Advice, { robot, fault }: RobotInError): Pick<Advice, 'key' | 'values'> {
  const isRobot = key === 'error.noRobot';
  if (!isRobot && key !== 'error.noDevice') return { key, values };
  if (fault !== null) return fault;
  if (robot === null) return isRobot ? { key, values } : { key: 'error.noDeviceBare', values: {} };
  return isRobot ? { key: 'error.robotSilent', values: { robot } } : { key, values };
}
