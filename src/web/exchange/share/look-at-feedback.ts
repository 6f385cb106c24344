import { readFeedback } from '#check/feedback/feedback';
import { runOfFeedback } from '#check/feedback/feedback-project';

import { t } from '../../kit/i18n';
import { repeatShown } from '../../session/run/repeat-shown';
import type { Workplace } from '../../session/work/model/parts';
import { showRun, tell, watchLate } from './show-run';
import shareWords from './words';

const words = shareWords.feedback;

/**
 * Looks at the moment of the feedback in the project that was just opened: its run is made again up to there. Where that cannot
 * be, a message says so; program and note are there in any case.
 *
 * @param file its name in messages
 */
export async function lookAtFeedback(app: Workplace, file: string): Promise<void> {
  const { project } = app.work.work.value;
  const read = readFeedback(project);
  if (read === 'damaged' || read === 'newer') {
    tell(app, 'warn', t(words[read], { file }));
    return;
  }
  const asked = runOfFeedback(project);
  app.work.noteHandedIn();
  if (asked === null) {
    tell(app, 'warn', t(words.failed, { file }));
    return;
  }
  const { setup, untilUs, untilProgramEnds, atUs } = asked;
  const giveUp = new AbortController();
  const isLate = watchLate(app, () => giveUp.abort());
  try {
    const wish = { setup, untilUs, untilProgramEnds, momentsSinceUs: -1 };
    const repeated = await repeatShown(app, wish, (percent) => t(words.making, { percent }), giveUp);
    if (isLate() || repeated === null) return;
    const endUs = repeated.result.simulatedUs;
    await showRun(app, repeated, {
      ...{ kept: setup, untilUs: endUs, ends: { untilUs, untilProgramEnds } },
      atUs: Math.min(atUs ?? endUs, endUs),
    });
  } catch {
    if (!isLate()) tell(app, 'warn', t(words.failed, { file }));
  } finally {
    isLate.end();
  }
}
