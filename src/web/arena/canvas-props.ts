import type { OptionValues } from '#core/option';
import type { Scene } from '#scene/scene';
import type { Snapshot } from '#simulation/snapshot';
import type { CourseEditorModel } from '../course-editor/state/course-editor-model';
import type { Trail } from '../run/trail';
import type { ArenaOptions, RobotLook } from './model/arena-model';

/** What the arena draws. */
export interface CanvasProps {
  /** The course as it is to be shown before a run: where the hand has put things. Replace the object to change it. */
  scene: Scene;
  /** The course as it is kept, if it is another. */
  course?: Scene;
  /** Whose tools change the course; left out: there is only the hand. */
  editor?: CourseEditorModel;
  /**
   * Reads the newest state of the run, or `null` before a run: then the course's own start is shown. A function, so that
   * a new state paints the canvas and renders no component.
   */
  newest: () => Snapshot | null;
  /** Whether the hand may take nothing; who tries is told. Left out: it may. */
  refuses?: () => boolean;
  /** The robot to draw, or `null` for none. */
  robot: RobotLook | null;
  /** The robot's options: they show its attachments before a run. */
  robotOptions: OptionValues;
  options: ArenaOptions;
  /** Where the robot has come by in this run. It changes with the state of the run. */
  trail: Trail;
  /** Keep the robot in the middle of the picture. */
  follow: boolean;
  /** Dark page. */
  dark: boolean;
  /** Name of the arena for screen readers, and whether they are told elsewhere what happens in it. */
  label: string;
  told?: boolean;
}
