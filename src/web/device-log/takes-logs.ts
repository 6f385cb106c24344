import type { PageParts } from '../page/parts';
import type { RunParts } from '../run/parts';
import type { WorkParts } from '../work/model/parts';

/** What opening a log changes. */
export type TakesLogs = Pick<PageParts, 'notices'> & Pick<RunParts, 'dataLog'> & Pick<WorkParts, 'settings'>;
