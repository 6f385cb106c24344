import type { StrokeColor } from '#scene/scene';

/** The colours of the arena; names follow the tokens of the page, so both stay one look. */
export interface Palette {
  /** Around the arena. */
  readonly canvas: string;
  readonly floor: string;
  readonly floorEdge: string;
  readonly floorShade: string;
  readonly gridFine: string;
  readonly grid: string;
  readonly gridStrong: string;
  readonly rulerText: string;
  readonly rulerTick: string;
  readonly strokes: Readonly<Record<StrokeColor, string>>;
  /** Around white and yellow strokes, which a light floor would swallow. */
  readonly strokeEdge: string;
  readonly movable: string;
  readonly movableLight: string;
  readonly movableInk: string;
  readonly fixed: string;
  readonly fixedInk: string;
  readonly fixedEdge: string;
  readonly wall: string;
  readonly wallLight: string;
  readonly wallInk: string;
  /** A target, its ground and its label. */
  readonly target: string;
  readonly targetFill: string;
  readonly checkpoint: string;
  readonly checkpointFill: string;
  readonly forbidden: string;
  readonly forbiddenFill: string;
  /** Ground of a zone's sign. */
  readonly signGround: string;
  /** A reached checkpoint or target. */
  readonly reached: string;
  readonly spikes: string;
  readonly spikesInk: string;
  readonly mover: string;
  readonly moverLight: string;
  readonly moverInk: string;
  readonly label: string;
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

/** On a light page. Every pair of sign and ground has a contrast of 3:1 at least, text 4.5:1. */
export const lightPalette: Palette = {
  canvas: '#DDE1E6',
  floor: '#FBFAF7',
  floorEdge: '#7B8491',
  floorShade: 'rgba(27, 31, 36, 0.16)',
  gridFine: '#F2F0EB',
  grid: '#E7E5DF',
  gridStrong: '#D5D2CA',
  rulerText: '#48515C',
  rulerTick: '#5C6671',
  strokes: {
    black: '#17191C',
    gray: '#8B8F94',
    white: '#FFFFFF',
    red: '#D3313B',
    yellow: '#F7CE1B',
    green: '#2C8A4F',
    blue: '#2460C4',
  },
  strokeEdge: '#C9C5BC',
  movable: '#A9DEC5',
  movableLight: '#BCE8D3',
  movableInk: '#0A5A41',
  fixed: '#B3282D',
  fixedInk: '#FFFFFF',
  fixedEdge: '#5C0F13',
  wall: '#4B5563',
  wallLight: '#5A6575',
  wallInk: '#8993A1',
  target: '#2563B8',
  targetFill: 'rgba(37, 99, 184, 0.11)',
  checkpoint: '#0B6E7C',
  checkpointFill: 'rgba(11, 110, 124, 0.1)',
  forbidden: '#B3282D',
  forbiddenFill: 'rgba(179, 40, 45, 0.1)',
  signGround: '#FFFFFF',
  reached: '#1B7A3A',
  spikes: '#23272E',
  spikesInk: '#FFC83D',
  mover: '#F4C430',
  moverLight: '#FAD766',
  moverInk: '#4A3200',
  label: '#2A3038',
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

/** On a dark page. The floor stays light: the line sensors see light and dark. */
export const darkPalette: Palette = {
  canvas: '#23282F',
  floor: '#D3D6DA',
  floorEdge: '#8791A0',
  floorShade: 'rgba(0, 0, 0, 0.45)',
  gridFine: '#CCD0D4',
  grid: '#C6CACF',
  gridStrong: '#B3B8BF',
  rulerText: '#BAC2CD',
  rulerTick: '#9CA6B3',
  strokes: {
    black: '#131518',
    gray: '#75797E',
    white: '#F4F5F6',
    red: '#BC2730',
    yellow: '#E3BA10',
    green: '#237541',
    blue: '#1C4FA6',
  },
  strokeEdge: '#AEB3BA',
  movable: '#8CCBAF',
  movableLight: '#9DD6BD',
  movableInk: '#07442F',
  fixed: '#A32329',
  fixedInk: '#FFFFFF',
  fixedEdge: '#540D11',
  wall: '#3C4653',
  wallLight: '#4A5564',
  wallInk: '#8590A0',
  target: '#1B4F99',
  targetFill: 'rgba(37, 99, 184, 0.17)',
  checkpoint: '#085662',
  checkpointFill: 'rgba(11, 110, 124, 0.16)',
  forbidden: '#9A1F24',
  forbiddenFill: 'rgba(179, 40, 45, 0.15)',
  signGround: '#F4F5F6',
  reached: '#14612D',
  spikes: '#1B1F25',
  spikesInk: '#F5BE35',
  mover: '#DDB02A',
  moverLight: '#E8C252',
  moverInk: '#3D2A00',
  label: '#1F252C',
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
