import type { PageParts } from '../../kit/parts';
import type { LayoutParts } from '../layout/parts';
import { mispluggedNotice } from '../work/hardware/misplugged';
import { fittedNow, hardwareNow } from '../work/hardware/use-hardware';
import type { WorkParts } from '../work/model/parts';

/** The models that show a run's messages. */
export type RunMessages = WorkParts & Pick<PageParts, 'notices'> & Pick<LayoutParts, 'layout'>;

/**
 * Shows a notice about a robot that does not fit board or program if neither arena nor console, which say so themselves,
 * are in sight; otherwise closes the notice.
 */
export function showStart(parts: RunMessages): void {
  const { settings, layout, notices } = parts;
  const isUnsaid = (): boolean => !layout.isShown.value.arena && !layout.isShown.value.console;
  const notice = isUnsaid() ? mispluggedNotice(fittedNow(parts, 0), (wish) => settings.change(wish)) : null;
  if (notice === null) notices.close();
  else notices.show({ ...notice, holds: isUnsaid });
}

/** Shows why a run could not begin. The code that measures a course is loaded only then. */
export async function showFailure(parts: RunMessages, message: string): Promise<void> {
  const { work, notices } = parts;
  const [hardware, scene] = [hardwareNow(parts), work.scene.value];
  try {
    const { failureNotice } = await import('../run/failure-notice');
    notices.show(failureNotice(message, hardware, scene));
  } catch {
    notices.show({ kind: 'error', key: 'notice.failed', values: { message } });
  }
}
