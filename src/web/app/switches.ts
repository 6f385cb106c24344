import type { PageParts } from '../kit/parts';
import type { WorkParts } from '../session/work/model/parts';

type Settings = Pick<WorkParts, 'settings'>;

/** Turns the sound on or off, and says in words what that means. */
export function switchSound({ settings, notices }: Settings & Pick<PageParts, 'notices'>): void {
  const muted = !settings.current.value.muted;
  settings.change({ muted });
  notices.show({ kind: 'info', key: muted ? 'notice.muted' : 'notice.unmuted' });
}

/** Switches between light and dark. */
export function switchTheme({ settings }: Settings): void {
  settings.change({ theme: document.documentElement.dataset['theme'] === 'dark' ? 'light' : 'dark' });
}
