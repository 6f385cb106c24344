import { travelling } from '../project/travelling';
import type { App } from './use-app';

/** Writes into the present work what it runs on, so that it comes back with it. @param from the settings as they hold now, or others */
export function stampSettings({ work, settings }: Pick<App, 'work' | 'settings'>, from = settings.current.value): void {
  const { project } = work.work.value;
  work.work.value = { ...work.work.value, project: { ...project, settings: travelling(from) } };
}
