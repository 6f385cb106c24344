import type { PageParts } from '../../kit/parts';
import type { LayoutParts } from '../layout/parts';
import { mispluggedNotice } from '../work/hardware/misplugged';
import { hardwareNow } from '../work/hardware/use-hardware';
import type { WorkParts } from '../work/model/parts';

/** The models that show a run's messages. */
export type RunMessages = WorkParts & Pick<PageParts, 'notices'> & Pick<LayoutParts, 'layout'>;

/**
 * Shows a notice about a robot that does not fit board or program if the arena, which says so itself, is not in sight;
 * otherwise closes the notice.
 */
export function showStart({ settings, work, layout, notices }: RunMessages): void {
  const notice = layout.isShown.value.arena
    ? null
    : mispluggedNotice(work.work.value.project, settings.current.value, (wish) => settings.change(wish));
  if (notice === null) notices.close();
  else notices.show(notice);
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
