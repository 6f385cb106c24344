import { optionOf, type Option } from '#core/option';
import words from './words';

const choices = ['none', 'huskylens', 'huskylens-down'] as const;
export type CameraChoice = (typeof choices)[number];

/** The option of the camera that every robot may carry. Light: the page loads it before anything runs. */
export const cameraOption: Option = optionOf('camera', words.camera, choices);
