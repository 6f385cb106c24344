import { darkColors, lightColors, type CourseColors } from '#picture/colors';

/** The colours of the arena; names follow the tokens of the page, so both stay one look. */
export interface Palette extends CourseColors {
  /** Around the arena. */
  readonly canvas: string;
  readonly floorEdge: string;
  readonly floorShade: string;
  readonly gridFine: string;
  readonly grid: string;
  readonly gridStrong: string;
  readonly rulerText: string;
  readonly rulerTick: string;
  readonly trace: string;
  readonly traceCasing: string;
  readonly cone: string;
  /** The centre of rotation. */
  readonly centre: string;
  /** Guide lines and distances. */
  readonly guide: string;
  readonly pill: string;
  readonly pillText: string;
  readonly hand: string;
  readonly handGround: string;
}

/** On a light page. */
export const lightPalette: Palette = {
  ...lightColors,
  canvas: '#DDE1E6',
  floorEdge: '#7B8491',
  floorShade: 'rgba(27, 31, 36, 0.16)',
  gridFine: '#F2F0EB',
  grid: '#E7E5DF',
  gridStrong: '#D5D2CA',
  rulerText: '#48515C',
  rulerTick: '#5C6671',
  trace: '#1E66D0',
  traceCasing: '#FFFFFF',
  cone: '#E06A00',
  centre: '#8A2BB8',
  guide: '#B8137A',
  pill: '#1B1F24',
  pillText: '#FFFFFF',
  hand: '#D9691E',
  handGround: '#FFFFFF',
};

/** On a dark page. */
export const darkPalette: Palette = {
  ...darkColors,
  canvas: '#23282F',
  floorEdge: '#8791A0',
  floorShade: 'rgba(0, 0, 0, 0.45)',
  gridFine: '#CCD0D4',
  grid: '#C6CACF',
  gridStrong: '#B3B8BF',
  rulerText: '#BAC2CD',
  rulerTick: '#9CA6B3',
  trace: '#1554B5',
  traceCasing: '#FFFFFF',
  cone: '#C25400',
  centre: '#6F1D99',
  guide: '#9C0F67',
  pill: '#1B1F24',
  pillText: '#FFFFFF',
  hand: '#C25400',
  handGround: '#FFFFFF',
};

/** The sans-serif of the page, for text on a canvas. */
export const canvasFont = 'Roboto, "Segoe UI", -apple-system, "Noto Sans", "Liberation Sans", Arial, sans-serif';
