import { isLowThing } from '#scene/kinds/heights';
import type { Scene } from '#scene/scene';
import type { CourseEditorParts } from '../../../course/editor/state/parts';
import type { RunParts } from '../../../session/run/parts';
import type { WorkParts } from '../../../session/work/model/parts';
import type { ArenaOptions } from '../model/arena-model';

type Parts = Pick<RunParts & WorkParts & CourseEditorParts, 'run' | 'work' | 'editor'>;

/** True if something stands above the picture of the arena: other robots, ghosts, places to ask why, heights, points. */
export const hasGuests = (parts: Parts, options: ArenaOptions, scene: Scene): boolean =>
  parts.work.hasSeveral.value ||
  scene.league !== undefined ||
  parts.run.earlier.value !== null ||
  parts.run.recording.value.setup !== null ||
  parts.run.snapshot.value?.switched !== undefined ||
  saysHeights(parts, options, scene);

/** True while the sight of the robot is shown and there are low things, here or in the course of the run. */
export const saysHeights = ({ editor }: Pick<Parts, 'editor'>, { cone }: ArenaOptions, scene: Scene): boolean =>
  cone && [scene, editor.runStart.value].some((course) => course?.objects.some(isLowThing));
