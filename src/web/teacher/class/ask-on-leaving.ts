import { askBeforeLeaving } from '../../kit/state/ask-before-leaving';
import type { ClassKeeper } from './class-keeper';
import type { ClassModel } from './model/class-model';

/** Has the browser ask before results or notes are lost with the page. */
export const askOnLeaving = (model: ClassModel, keeper: Pick<ClassKeeper, 'isKept'>): void =>
  askBeforeLeaving(() => model.isUnsaved.value && !keeper.isKept.value);
