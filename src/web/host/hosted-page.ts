import type { ConsoleParts } from '../console/parts';
import type { CourseEditorParts } from '../course-editor/state/parts';
import type { DebugParts } from '../debug/parts';
import type { LayoutParts } from '../layout/parts';
import type { PageParts } from '../page/parts';
import type { RunParts } from '../run/parts';
import type { VisitParts } from '../visit/parts';
import type { WorkParts } from '../work/model/parts';

/** The part of the page that a host can reach. */
export type HostedPage = Pick<PageParts, 'notices'> &
  Pick<RunParts, 'run' | 'sensors' | 'hand'> &
  WorkParts &
  VisitParts &
  Pick<LayoutParts, 'layout'> &
  Pick<ConsoleParts, 'console'> &
  Pick<CourseEditorParts, 'editor'> &
  DebugParts;
