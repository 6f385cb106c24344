import type { PageParts } from '../../kit/parts';
import { t } from '../../kit/i18n';
import words from './words';

/** Shows a message to somebody who wants to build while looking back: why nothing changes, and the way out. */
export function explainStandstill(notices: PageParts['notices']): void {
  notices.show({ kind: 'info', key: 'notice.text', values: { text: t(words.standsStill) } });
}
