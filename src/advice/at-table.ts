import type { AdviceKey, AdviceValues } from './text';

/** The robot of a device, as far as it can cause an error. */
export interface AtTable {
  /** Name of the robot; `null`: none. */
  readonly robot: string | null;
  /** The reason why it cannot answer; `null`: it can, or the reason is unknown. */
  readonly fault: { readonly key: AdviceKey; readonly values: AdviceValues } | null;
}

/** True for an error of a robot or a chip that does not answer: what is plugged in explains it. */
export const isSilence = (key: string): boolean => key === 'error.noRobot' || key === 'error.noDevice';

/** The reason why no robot or chip answers, from what is plugged in; other advice is unchanged. */
export function atTable<T extends { readonly key: AdviceKey; readonly values: AdviceValues }>(
  advice: T,
  { robot, fault }: AtTable,
): T {
  if (!isSilence(advice.key)) return advice;
  const isRobot = advice.key === 'error.noRobot';
  if (fault !== null) return { ...advice, ...fault };
  if (robot === null) return isRobot ? advice : { ...advice, key: 'error.noDeviceBare', values: {} };
  return isRobot ? { ...advice, key: 'error.robotSilent', values: { robot } } : advice;
}
