import { travelling } from '../project/travelling';
import type { App } from './use-app';

/** Writes into the present work what it runs on, so that it comes back with it. */
export function stampSettings({ work, settings }: Pick<App, 'work' | 'settings'>): void {
  const { project } = work.work.value;
  work.work.value = { ...work.work.value, project: { ...project, settings: travelling(settings.current.value) } };
}
