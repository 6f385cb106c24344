import { watch } from 'vue';

import type { PageParts } from '../../kit/parts';
import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';

type Around = Pick<PageParts, 'notices'> & Pick<RunParts, 'run' | 'hand'> & Pick<WorkParts, 'work'>;

/**
 * Shows a notice when robot or blocks are moved by hand while there is no run: every run begins where the course has
 * them. The robot's place can be made the start.
 */
export function tellIdleHand({ notices, run, hand, work }: Around): void {
  /**
   * Makes the robot's place the start. The code for it is loaded with the first press: few do it. Without a connection
   * nothing happens.
   */
  async function startHere(): Promise<void> {
    const edits = await import('#editor/edits').catch(() => null);
    const pose = hand.pose.value;
    if (pose === null || edits === null) return;
    const at = [Math.round(pose.xMm), Math.round(pose.yMm)] as const;
    const edit = edits.startingAt(work.scene.value, { at, heading: Math.round(pose.headingDeg) });
    hand.reset();
    if (edit !== null) work.edit(edit);
  }
  watch([hand.pose, hand.blocks], ([pose, blocks]) => {
    const hasBlocks = Object.keys(blocks).length > 0;
    if (pose === null && !hasBlocks) return;
    const key = pose === null ? 'notice.handBlock' : 'notice.handRobot';
    if (notices.current.value?.key === key) return;
    notices.show({
      kind: 'info',
      key,
      ...(pose === null ? {} : { action: { key: 'notice.startHere', run: () => void startHere() } as const }),
      holds: () =>
        !run.isActive.value && (pose === null ? Object.keys(hand.blocks.value).length > 0 : hand.pose.value !== null),
    });
  });
}
