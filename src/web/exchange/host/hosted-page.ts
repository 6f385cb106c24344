import type { ConsoleParts } from '../../pupil/console/parts';
import type { CourseEditorParts } from '../../course/editor/state/parts';
import type { DebugParts } from '../../pupil/debug/parts';
import type { LayoutParts } from '../../session/layout/parts';
import type { ModeParts } from '../../session/mode/parts';
import type { PageParts } from '../../kit/parts';
import type { RunParts } from '../../session/run/parts';
import type { VisitParts } from '../../session/visit/parts';
import type { WorkParts } from '../../session/work/model/parts';

/** The part of the page that a host can reach. */
export type HostedPage = Pick<PageParts, 'notices'> &
  Pick<RunParts, 'run' | 'sensors' | 'hand'> &
  WorkParts &
  VisitParts &
  Pick<LayoutParts, 'layout'> &
  Pick<ConsoleParts, 'console'> &
  Pick<CourseEditorParts, 'editor'> &
  DebugParts &
  ModeParts;
