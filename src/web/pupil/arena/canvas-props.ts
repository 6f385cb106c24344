import type { OptionValues } from '#core/option';
import type { Scene } from '#scene/scene';
import type { Snapshot } from '#simulation/snapshot';
import type { CourseEditorModel } from '../../course/editor/state/course-editor-model';
import type { Trail } from '../../session/run/trail';
import type { ArenaOptions, RobotLook } from './model/arena-model';

/** Props of the arena. */
export interface CanvasProps {
  /** The course as shown before a run: with the things where the hand has put them. Replace the object to change it. */
  scene: Scene;
  /** The course as stored, if it differs. */
  course?: Scene;
  /** The editor whose tools change the course; left out: the hand is the only tool. */
  editor?: CourseEditorModel;
  /**
   * Reads the newest state of the run, or `null` before a run: then the course's own start is shown. A function, so
   * that a new state paints the canvas and renders no component.
   */
  newest: () => Snapshot | null;
  /** True if the hand may take nothing; an attempt shows why. Left out: it may take everything. */
  refuses?: () => boolean;
  /** The robot to draw, or `null` for none. */
  robot: RobotLook | null;
  /** The robot's options: they show its attachments before a run. */
  robotOptions: OptionValues;
  options: ArenaOptions;
  /** The path of the robot in this run. It changes with the state of the run. */
  trail: Trail;
  /** Holds the robot in the middle third of the picture. */
  follow: boolean;
  /** Dark page. */
  dark: boolean;
  /** Name of the arena for screen readers. */
  label: string;
  /** True if events in the arena are announced elsewhere. */
  told?: boolean;
}
