// What a file of tests needs to end, whatever happens: a limit for each test, and one for what is left running after the
// last of them.
import {after, it as test} from "node:test";

const TEST_LIMIT = 180_000;
const LEFT_OVER_LIMIT = 10_000;

/** A test that fails, by its name, where it does not end. */
export function it(name, body) {
  return test(name, {timeout: TEST_LIMIT}, body);
}

after(() => {
  setTimeout(() => {
    console.error(`something that the tests began still runs ${LEFT_OVER_LIMIT / 1000} s after the last of them`);
    process.exit(1);
  }, LEFT_OVER_LIMIT).unref();
});
