// Time limits that end a test file in any case: a limit for each test, and a limit for processes that still run after
// the last test.
import {after, it as test} from "node:test";

const TEST_LIMIT = 180_000;
const LEFT_OVER_LIMIT = 10_000;

/** Defines a test that fails, with its name in the message, if it does not end in time. */
export function it(name, body) {
  return test(name, {timeout: TEST_LIMIT}, body);
}

after(() => {
  setTimeout(() => {
    console.error(`something that the tests began still runs ${LEFT_OVER_LIMIT / 1000} s after the last of them`);
    process.exit(1);
  }, LEFT_OVER_LIMIT).unref();
});
