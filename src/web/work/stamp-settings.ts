import { travelling } from './settings/travelling';
import type { App } from '../app/use-app';

/**
 * Writes into the present work what it runs on, so that it comes back with it. What a host or the address holds belongs to
 * the work that they brought: work of the pupil's own is kept with the pupil's own choice.
 */
export function stampSettings({ work, settings, host }: Pick<App, 'work' | 'settings' | 'host'>): void {
  const { project } = work.work.value;
  const from = host.hasBrought ? settings.current.value : settings.own.value;
  work.work.value = { ...work.work.value, project: { ...project, settings: travelling(from) } };
}
