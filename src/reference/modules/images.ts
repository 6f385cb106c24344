import { fn, type, values } from '../table';

/** The type `Image`. Source: micropython-microbit-v2, src/codal_port/microbit_image.c. */
export const image = type(["(text: str = '', /)", '(width: int, height: int, buffer: bytes | None = None, /)'], {
  width: fn('() -> int'),
  height: fn('() -> int'),
  get_pixel: fn('(x: int, y: int) -> int'),
  set_pixel: fn('(x: int, y: int, value: int) -> None'),
  shift_left: fn('(n: int) -> Image'),
  shift_right: fn('(n: int) -> Image'),
  shift_up: fn('(n: int) -> Image'),
  shift_down: fn('(n: int) -> Image'),
  crop: fn('(x: int, y: int, w: int, h: int) -> Image'),
  copy: fn('() -> Image'),
  invert: fn('() -> Image'),
  fill: fn('(value: int) -> None'),
  blit: fn('(src: Image, x: int, y: int, w: int, h: int, xdest: int = 0, ydest: int = 0, /) -> None'),
  ...values('Image', ['HEART', 'HEART_SMALL', 'HAPPY', 'SMILE', 'SAD', 'CONFUSED', 'ANGRY', 'ASLEEP', 'SURPRISED']),
  ...values('Image', ['SILLY', 'FABULOUS', 'MEH', 'YES', 'NO']),
  ...values('Image', ['CLOCK12', 'CLOCK1', 'CLOCK2', 'CLOCK3', 'CLOCK4', 'CLOCK5', 'CLOCK6', 'CLOCK7', 'CLOCK8']),
  ...values('Image', ['CLOCK9', 'CLOCK10', 'CLOCK11']),
  ...values('Image', ['ARROW_N', 'ARROW_NE', 'ARROW_E', 'ARROW_SE', 'ARROW_S', 'ARROW_SW', 'ARROW_W', 'ARROW_NW']),
  ...values('Image', ['TRIANGLE', 'TRIANGLE_LEFT', 'CHESSBOARD', 'DIAMOND', 'DIAMOND_SMALL', 'SQUARE']),
  ...values('Image', ['SQUARE_SMALL', 'RABBIT', 'COW', 'MUSIC_CROTCHET', 'MUSIC_QUAVER', 'MUSIC_QUAVERS']),
  ...values('Image', ['PITCHFORK', 'XMAS', 'PACMAN', 'TARGET', 'TSHIRT', 'ROLLERSKATE', 'DUCK', 'HOUSE', 'TORTOISE']),
  ...values('Image', ['BUTTERFLY', 'STICKFIGURE', 'GHOST', 'SWORD', 'GIRAFFE', 'SKULL', 'UMBRELLA', 'SNAKE']),
  ...values('Image', ['SCISSORS']),
  ...values('list[Image]', ['ALL_CLOCKS', 'ALL_ARROWS']),
});
