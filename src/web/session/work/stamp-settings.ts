import { travelling } from './settings/travelling';
import type { WorkParts } from './model/parts';

/**
 * Writes the settings that a run depends on into the present work, so that they come back with it. Work that a host or
 * the address brought gets the current ones, the pupil's own work the pupil's own choice.
 */
export function stampSettings({ work, settings }: WorkParts): void {
  const { project } = work.work.value;
  const from = work.isBrought ? settings.current.value : settings.own.value;
  work.work.value = { ...work.work.value, project: { ...project, settings: travelling(from) } };
}
