/** The ways to bring parts of the arena into sight. */
export interface ViewActs {
  /** The whole arena, and what lies outside of it. */
  readonly fit: () => void;
  /** The robot and the nearest thing that it could bump into. */
  readonly near: () => void;
  readonly selected: () => void;
  readonly trueSize: () => void;
}
