/** Tests of the lab's page in a real browser, Chromium without a window: {@code gradle browserTests}. */
package browser;
