import type { Workplace } from '../../work/model/parts';
import type { LayoutParts } from '../parts';
import type { Stage } from './stage';
import { latePart } from '../../../kit/late-part';

/** Brings a stage into sight, see `changeStage`, which is loaded with the first choice. */
export async function chooseStage(app: Workplace & Pick<LayoutParts, 'layout'>, stage: Stage): Promise<void> {
  try {
    const { changeStage } = await import('./change-stage');
    changeStage(app, stage);
  } catch {
    app.notices.show(latePart);
  }
}
