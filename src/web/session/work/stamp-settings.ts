import { travelling } from './settings/travelling';
import type { WorkParts } from './model/parts';

/**
 * Writes into the present work what it runs on, so that it comes back with it. What a host or the address holds belongs to
 * the work that they brought: work of the pupil's own is kept with the pupil's own choice.
 */
export function stampSettings({ work, settings }: WorkParts): void {
  const { project } = work.work.value;
  const from = work.isBrought ? settings.current.value : settings.own.value;
  work.work.value = { ...work.work.value, project: { ...project, settings: travelling(from) } };
}
