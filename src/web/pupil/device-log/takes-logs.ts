import type { PageParts } from '../../kit/parts';
import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';

/** The models that opening a log changes. */
export type TakesLogs = Pick<PageParts, 'notices'> & Pick<RunParts, 'dataLog'> & Pick<WorkParts, 'settings'>;
