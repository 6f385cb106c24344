// The code that makes samples, in a file of its own: it is fetched for the first effect or the first word.
export { EFFECT_RATE, renderEffect } from '#board/sound/render-effect';
export { speechPieces, SPEECH_RATE } from '#board/sound/render-speech';
