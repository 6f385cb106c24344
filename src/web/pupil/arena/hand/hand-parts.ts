/** The hand and its marks in the picture: loaded when the arena is first touched. */
export { Hand } from './hand';
export { handMarks } from './hand-marks';
export { placedPose } from './hand-gesture';
