/** Says what the tests are doing while they run. */
package progress;
